#include "ariadne/statistics/exact_tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <numeric>

#include "ariadne/core/error.h"

namespace ariadne::statistics {
namespace {

std::vector<std::size_t> ascending(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

/// Hypergeometric probabilities of first + 0, 1, ... successes in arm 1, by the ratio of
/// neighbours, outwards from the mode so that nothing overflows.
std::vector<double> hypergeometric(double n1, double n2, double successes) {
  const double first = std::max(0.0, successes - n2);
  const double last = std::min(n1, successes);
  std::vector<double> h(static_cast<std::size_t>(last - first) + 1);
  const double mode =
      std::clamp(std::floor((successes + 1) * (n1 + 1) / (n1 + n2 + 2)), first, last);
  const auto at = static_cast<std::size_t>(mode - first);
  const auto up = [&](double a) {  // h(a + 1) / h(a)
    return (n1 - a) * (successes - a) / ((a + 1) * (n2 - successes + a + 1));
  };
  h[at] = 1;
  for (std::size_t i = at; i + 1 < h.size(); ++i)
    h[i + 1] = h[i] * up(first + static_cast<double>(i));
  for (std::size_t i = at; i > 0; --i) h[i - 1] = h[i] / up(first + static_cast<double>(i - 1));
  const double sum = std::accumulate(h.begin(), h.end(), 0.0);
  for (double& v : h) v /= sum;
  return h;
}

}  // namespace

double mcnemarTest(std::size_t only_first, std::size_t only_second) {
  if (only_first == only_second) return 1;
  const boost::math::binomial coin(static_cast<double>(only_first + only_second), 0.5);
  const auto fewer = static_cast<double>(std::min(only_first, only_second));
  return std::min(1.0, 2 * boost::math::cdf(coin, fewer));
}

std::vector<double> fisherPValues(std::size_t trials1, std::size_t trials2, std::size_t successes) {
  const auto h = hypergeometric(static_cast<double>(trials1), static_cast<double>(trials2),
                                static_cast<double>(successes));
  constexpr double kEqual = 1 + 1e-7;
  const auto order = ascending(h);
  std::vector<double> p(h.size());
  double sum = 0;
  std::size_t summed = 0;
  for (const std::size_t i : order) {
    while (summed < order.size() && h[order[summed]] <= h[i] * kEqual) sum += h[order[summed++]];
    p[i] = std::min(1.0, sum);
  }
  return p;
}

double fisherTest(std::size_t successes1, std::size_t trials1, std::size_t successes2,
                  std::size_t trials2) {
  if (successes1 > trials1 || successes2 > trials2)
    throw core::Error(fmt::format("{} of {} against {} of {}: more successes than trials",
                                  successes1, trials1, successes2, trials2));
  const std::size_t successes = successes1 + successes2;
  const std::size_t first = successes > trials2 ? successes - trials2 : 0;
  return fisherPValues(trials1, trials2, successes)[successes1 - first];
}

std::vector<double> holmAdjusted(const std::vector<double>& p_values) {
  for (const double p : p_values)
    if (!(p >= 0 && p <= 1)) throw core::Error(fmt::format("a p-value of {} is not in [0, 1]", p));
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  auto left = static_cast<double>(p_values.size());
  for (const std::size_t i : ascending(p_values)) {
    largest = std::max(largest, std::min(1.0, left-- * p_values[i]));
    adjusted[i] = largest;
  }
  return adjusted;
}

}  // namespace ariadne::statistics
