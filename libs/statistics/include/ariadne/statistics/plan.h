// How many runs an experiment needs to tell two rates apart.
#pragma once
#include <cstddef>

namespace ariadne::statistics {

/// What the planned test is to achieve.
struct PlanGoal {
  double power = 0.8;   ///< probability of a significant result when the rates are as assumed
  double level = 0.05;  ///< two-sided
};

/// How many runs an experiment needs to show a difference of rates.
struct Plan {
  std::size_t runs = 0;  ///< seeds an arm (unpaired) or pairs
  double power = 0;      ///< the exact test's with that many; the goal's when not exact
  bool exact = true;     ///< false: by the normal formula, too many for exact sums
};

/// Power of fisherTest() <= level, summed over all outcomes of Bin(n1, p1) x Bin(n2, p2).
double fisherPower(std::size_t n1, double p1, std::size_t n2, double p2, double level = 0.05);

/// Power of mcnemarTest() <= level with `pairs` pairs, of which shares only_first and only_second
/// are discordant each way, summed over all outcomes (not given the number of discordant ones).
double mcnemarPower(std::size_t pairs, double only_first, double only_second, double level = 0.05);

/// Fewest seeds an arm (not under half the normal formula's) for which fisherPower() reaches the
/// goal. Exact power is a saw: a few more may give slightly less. Over 1000 an arm by the formula
///   n' = (z_a sqrt(2 m (1 - m)) + z_b sqrt(p1 (1 - p1) + p2 (1 - p2)))^2 / (p1 - p2)^2, m the
///   mean, n = n' / 4 (1 + sqrt(1 + 4 / (n' |p1 - p2|)))^2
/// (Casagrande, Pike and Smith 1978; Fleiss, Tytun and Ury, Biometrics 36, 1980).
/// Throws core::UsageError for equal rates or numbers out of bounds.
Plan planUnpaired(double p1, double p2, const PlanGoal& goal = {});

/// Fewest pairs likewise for mcnemarPower(). Over 10000 by Connor's formula (Biometrics 43, 1987)
///   n = (z_a sqrt(s) + z_b sqrt(s - d^2))^2 / d^2, s = only_first + only_second, d = difference.
Plan planPaired(double only_first, double only_second, const PlanGoal& goal = {});

/// The formulas themselves, not rounded: without continuity correction (n' above), and Connor's.
double normalSeeds(double p1, double p2, const PlanGoal& goal = {});
/// The same for pairs (McNemar).
double normalPairs(double only_first, double only_second, const PlanGoal& goal = {});

}  // namespace ariadne::statistics
