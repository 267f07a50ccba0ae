// Where programs are.
#pragma once
#include <filesystem>
#include <string>

namespace ariadne::process {

/// Whether this is a file that may be executed.
bool canRun(const std::filesystem::path& file);

/// An executable of the environment's PATH; empty when there is none of that name.
std::filesystem::path findInPath(const std::string& name);

/// A program of ours: beside the running one, else in PATH; empty when it is in neither.
std::filesystem::path findSister(const std::string& name);

}  // namespace ariadne::process
