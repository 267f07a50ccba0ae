// ariadne-eval plan: how many runs an experiment needs.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne::eval_app {

/// `args` behind the word plan. Prints the runs an arm, or pairs, for two rates to be told apart.
/// @return exit code. Throws core::UsageError.
int runPlan(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::eval_app
