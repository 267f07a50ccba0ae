// ariadne-experiment: many runs of the other programs, and what they come to.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne {

/// Returns the exit code.
int runExperimentApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

}  // namespace ariadne
