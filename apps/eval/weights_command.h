// ariadne-eval weights: how far the filter's weights are to be believed.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne::eval_app {

/// Maps drives with a known truth, and fits how far a particle's weight tells whether it is nearer
/// the truth than another. Throws core::UsageError for wrong use, core::Error for a file that
/// cannot be used.
int runWeights(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::eval_app
