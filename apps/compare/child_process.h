// A program run as a child, and what it cost.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::compare_app {

/// Of a whole process, from its start to its end.
struct ProcessCosts {
  double cpu_s = 0;  ///< user and system
  double wall_s = 0;
  double memory_mb = 0;  ///< largest resident set, MiB
};

/// Runs the command to its end, what it prints going to `log`.
/// @param command program (a path) and arguments
/// Throws core::Error with the log's last line when it cannot be started, fails or is killed.
ProcessCosts runChild(const std::vector<std::string>& command, const std::filesystem::path& log);

/// `given` if not empty, else the program of this name beside the running one, else on PATH.
/// Throws core::UsageError when there is none that can be run.
std::string findProgram(const std::string& given, const std::string& name);

}  // namespace ariadne::compare_app
