// How far weights are to be believed: the logistic fit of a single slope.
#pragma once
#include <vector>

namespace ariadne::statistics {

/// k of P(a is the better one | ln weight of a - ln weight of b = x) = 1 / (1 + exp(-k x)), by
/// maximum likelihood (Newton's method; the sum is concave in k). 1: the weights say what they
/// know; 0: they say nothing; under 0: they say the opposite.
/// @param ln_ratios x of each pair, a the better one. Infinite where all are positive (or all
/// negative, minus infinity), 0 for none.
double logisticSlope(const std::vector<double>& ln_ratios);

}  // namespace ariadne::statistics
