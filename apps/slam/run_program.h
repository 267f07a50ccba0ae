// What the programs that map have in common around their work: errors, warnings, progress.
#pragma once
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "progress.h"

namespace ariadne::slam_app {

/// Calls `run` and returns its exit code; an exception is told on `err` behind the program's name
/// and becomes 2 (wrong use) or 1.
int runProgram(const std::string& name, std::ostream& err, const std::function<int()>& run);

void warn(std::ostream& err, const std::string& program, const std::vector<std::string>& warnings);

/// A line rewritten where `err` is the terminal.
ProgressStyle progressStyle(bool quiet, const std::ostream& err);

}  // namespace ariadne::slam_app
