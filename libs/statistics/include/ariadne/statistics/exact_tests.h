// Exact tests of two rates, and the correction for several of them. All two-sided.
#pragma once
#include <cstddef>
#include <vector>

namespace ariadne::statistics {

/// McNemar's exact test, for two arms on the same seeds: p = min(1, 2 P(X <= min(b, c))),
/// X ~ Bin(b + c, 1/2), b and c the pairs in which only the one or only the other arm was right.
/// Pairs in which both or none were say nothing. 1 when there is no discordant pair.
double mcnemarTest(std::size_t only_first, std::size_t only_second);

/// Fisher's exact test, for two arms on different seeds: the probability, given the margins, of the
/// tables that are at most as likely as this one (those within 1e-7 of it count as equal, as in
/// R's fisher.test). 1 when an arm is empty.
/// Throws core::Error for more successes than trials.
double fisherTest(std::size_t successes1, std::size_t trials1, std::size_t successes2,
                  std::size_t trials2);

/// The p-value above for each count of successes in the first arm that the margins allow, from
/// max(0, successes - trials2) up.
/// @param successes of both arms, at most trials1 + trials2
std::vector<double> fisherPValues(std::size_t trials1, std::size_t trials2, std::size_t successes);

/// p-values adjusted for their number, in the given order: max over the smaller ones j of
/// min(1, (m - rank_j + 1) p_j) (Holm, Scand. J. Statistics 6, 1979). Those under the level may be
/// called significant together. Throws core::Error when one is not in [0, 1].
std::vector<double> holmAdjusted(const std::vector<double>& p_values);

}  // namespace ariadne::statistics
