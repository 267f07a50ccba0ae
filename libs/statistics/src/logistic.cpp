#include "ariadne/statistics/logistic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ariadne::statistics {
namespace {

struct Derivatives {
  double first = 0;
  double second = 0;
};

/// Of the log likelihood, sum of -ln(1 + exp(-k x)).
Derivatives derivativesAt(double k, const std::vector<double>& ln_ratios) {
  Derivatives d;
  for (const double x : ln_ratios) {
    const double wrong = 1 / (1 + std::exp(k * x));  // P(b is the better one)
    d.first += x * wrong;
    d.second -= x * x * wrong * (1 - wrong);
  }
  return d;
}

}  // namespace

double logisticSlope(const std::vector<double>& ln_ratios) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto [least, most] = std::minmax_element(ln_ratios.begin(), ln_ratios.end());
  if (ln_ratios.empty() || (*least == 0 && *most == 0)) return 0;
  if (*least >= 0) return kInfinity;
  if (*most <= 0) return -kInfinity;
  // The root of a falling function: bracketed, then Newton within the bracket.
  double low = -1;
  double high = 1;
  while (derivativesAt(low, ln_ratios).first < 0) low *= 2;
  while (derivativesAt(high, ln_ratios).first > 0) high *= 2;
  double k = 0;
  while (high - low > 1e-12 * std::max(1.0, std::abs(k))) {
    const Derivatives d = derivativesAt(k, ln_ratios);
    (d.first > 0 ? low : high) = k;
    const double next = d.second < 0 ? k - d.first / d.second : low;
    const double inside = next > low && next < high ? next : (low + high) / 2;
    if (std::abs(inside - k) < 1e-12 * std::max(1.0, std::abs(k))) return inside;
    k = inside;
  }
  return k;
}

}  // namespace ariadne::statistics
