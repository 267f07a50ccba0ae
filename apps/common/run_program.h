// What all programs have in common around their work: errors become exit codes, warnings.
#pragma once
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne::app {

/// Calls `run` and returns its exit code; an exception is told on `err` behind the program's name
/// and becomes 2 (wrong use) or 1.
int runProgram(const std::string& name, std::ostream& err, const std::function<int()>& run);

void warn(std::ostream& err, const std::string& program, const std::vector<std::string>& warnings);

}  // namespace ariadne::app
