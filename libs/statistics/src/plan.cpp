#include "ariadne/statistics/plan.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/statistics/exact_tests.h"
#include "checks.h"

namespace ariadne::statistics {
namespace {

using boost::math::binomial;

double normalQuantile(double p) { return boost::math::quantile(boost::math::normal(), p); }

std::vector<double> binomialPmf(std::size_t n, double p) {
  const binomial distribution(static_cast<double>(n), p);
  std::vector<double> pmf(n + 1);
  for (std::size_t k = 0; k <= n; ++k)
    pmf[k] = boost::math::pdf(distribution, static_cast<double>(k));
  return pmf;
}

void checkGoal(const PlanGoal& goal) {
  checkShare(goal.power, "power");
  checkShare(goal.level, "level");
}

/// (z_a sqrt(under equality) + z_b sqrt(under difference))^2 / difference^2.
double normalCount(double variance0, double variance1, double difference, const PlanGoal& goal) {
  const double z = normalQuantile(1 - goal.level / 2) * std::sqrt(variance0) +
                   normalQuantile(goal.power) * std::sqrt(variance1);
  return z * z / (difference * difference);
}

template <class Power>
Plan firstThatReaches(double normal, std::size_t most, double formula, const PlanGoal& goal,
                      Power&& power_of) {
  if (formula <= static_cast<double>(most))
    for (std::size_t n = std::max<std::size_t>(1, static_cast<std::size_t>(normal / 2)); n <= most;
         ++n) {
      const double power = power_of(n);
      if (power >= goal.power) return {n, power, true};
    }
  return {static_cast<std::size_t>(std::ceil(formula)), goal.power, false};
}

}  // namespace

double fisherPower(std::size_t n1, double p1, std::size_t n2, double p2, double level) {
  checkProbability(p1, "p1");
  checkProbability(p2, "p2");
  checkShare(level, "level");
  const auto first = binomialPmf(n1, p1);
  const auto second = binomialPmf(n2, p2);
  double power = 0;
  for (std::size_t successes = 0; successes <= n1 + n2; ++successes) {
    const std::size_t a0 = successes > n2 ? successes - n2 : 0;
    const auto p_values = fisherPValues(n1, n2, successes);
    for (std::size_t i = 0; i < p_values.size(); ++i)
      if (p_values[i] <= level) power += first[a0 + i] * second[successes - a0 - i];
  }
  return power;
}

double mcnemarPower(std::size_t pairs, double only_first, double only_second, double level) {
  checkProbability(only_first, "only_first");
  checkProbability(only_second, "only_second");
  checkProbability(only_first + only_second, "share of discordant pairs");
  checkShare(level, "level");
  const double discordant = only_first + only_second;
  if (discordant == 0) return 0;
  const auto share = binomialPmf(pairs, discordant);
  double power = 0;
  std::size_t rejected = 0;  // outcomes 0 .. rejected - 1 of d, and their mirror; grows with d
  for (std::size_t d = 1; d <= pairs; ++d) {
    while (2 * rejected < d && mcnemarTest(rejected, d - rejected) <= level) ++rejected;
    if (rejected == 0) continue;
    const binomial of_first(static_cast<double>(d), only_first / discordant);
    power +=
        share[d] *
        (boost::math::cdf(of_first, static_cast<double>(rejected - 1)) +
         boost::math::cdf(boost::math::complement(of_first, static_cast<double>(d - rejected))));
  }
  return power;
}

double normalSeeds(double p1, double p2, const PlanGoal& goal) {
  checkProbability(p1, "p1");
  checkProbability(p2, "p2");
  checkGoal(goal);
  if (p1 == p2) throw core::UsageError("equal rates cannot be told apart: p1 = p2");
  const double mean = (p1 + p2) / 2;
  return normalCount(2 * mean * (1 - mean), p1 * (1 - p1) + p2 * (1 - p2), p1 - p2, goal);
}

double normalPairs(double only_first, double only_second, const PlanGoal& goal) {
  checkProbability(only_first, "only_first");
  checkProbability(only_second, "only_second");
  const double discordant = only_first + only_second;
  checkProbability(discordant, "share of discordant pairs");
  checkGoal(goal);
  if (only_first == only_second)
    throw core::UsageError("equal rates cannot be told apart: only_first = only_second");
  const double difference = only_first - only_second;
  return normalCount(discordant, discordant - difference * difference, difference, goal);
}

Plan planUnpaired(double p1, double p2, const PlanGoal& goal) {
  constexpr std::size_t kMost = 1000;  // 40 ms a power at that
  const double plain = normalSeeds(p1, p2, goal);
  const double corrected =
      plain / 4 * std::pow(1 + std::sqrt(1 + 4 / (plain * std::abs(p1 - p2))), 2);
  return firstThatReaches(plain, kMost, corrected, goal,
                          [&](std::size_t n) { return fisherPower(n, p1, n, p2, goal.level); });
}

Plan planPaired(double only_first, double only_second, const PlanGoal& goal) {
  constexpr std::size_t kMost = 10000;
  const double plain = normalPairs(only_first, only_second, goal);
  return firstThatReaches(plain, kMost, plain, goal, [&](std::size_t n) {
    return mcnemarPower(n, only_first, only_second, goal.level);
  });
}

}  // namespace ariadne::statistics
