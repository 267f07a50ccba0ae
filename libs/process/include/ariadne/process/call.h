// Programs of the system that are asked or set to work: sbatch, squeue, sacct, parallel.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ariadne/process/process.h"

namespace ariadne::process {

/// How a program answered.
struct CallResult {
  bool missing = false;  ///< not in PATH
  bool ok = false;       ///< exit code 0
  std::string out;
  std::string error;  ///< its last words, or how it ended
};

/// Waits for it, at most `limit_s` seconds: a controller that is down lets its clients hang.
CallResult call(std::vector<std::string> argv, double limit_s = 60);

/// With this process's terminal, and no limit; returns when it has ended in any way. Ctrl-C reaches
/// it and not us. Throws core::Error when it cannot be started.
void callInForeground(const std::vector<std::string>& argv);

/// Runs the command to its end, what it prints going to `stdout_file`. Throws core::Error with its
/// last words when it cannot be started, fails or is killed.
/// @param meanwhile called while it runs, some times a second; may be none
ProcessEnd runToEnd(const std::vector<std::string>& argv, const std::filesystem::path& stdout_file,
                    const std::function<void(const Process&)>& meanwhile = {});

}  // namespace ariadne::process
