#include "ariadne/statistics/interval.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "ariadne/core/error.h"
#include "checks.h"

namespace ariadne::statistics {
namespace {

/// Reorders the values.
double medianOf(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

}  // namespace

Interval wilsonInterval(std::size_t successes, std::size_t trials, double confidence) {
  checkShare(confidence, "confidence");
  if (trials == 0 || successes > trials)
    throw core::Error(fmt::format("{} successes of {} trials have no rate", successes, trials));
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double centre = p + z * z / (2 * n);
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  const double scale = 1 + z * z / n;
  // The ends of 0 of n and n of n are exact; the subtraction above leaves 1e-17 of them.
  return {successes == 0 ? 0 : (centre - half) / scale,
          successes == trials ? 1 : (centre + half) / scale};
}

Interval medianInterval(std::vector<double> values, core::RandomStream& rng, double confidence,
                        std::size_t resamples) {
  checkShare(confidence, "confidence");
  if (values.empty() || resamples == 0)
    throw core::Error("a bootstrap takes at least one value and one resample");
  for (const double v : values)
    if (!std::isfinite(v)) throw core::Error("a bootstrap takes finite values");
  const auto n = static_cast<double>(values.size());
  std::vector<double> medians(resamples);
  std::vector<double> drawn(values.size());
  for (double& median : medians) {
    for (double& d : drawn) d = values[static_cast<std::size_t>(rng.uniform() * n)];
    median = medianOf(drawn);
  }
  std::sort(medians.begin(), medians.end());
  const double rank = static_cast<double>(resamples + 1) * (1 - confidence) / 2;
  const auto from_end =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(rank)), 1, resamples) - 1;
  const std::size_t low = std::min(from_end, resamples - 1 - from_end);
  return {medians[low], medians[resamples - 1 - low]};
}

}  // namespace ariadne::statistics
