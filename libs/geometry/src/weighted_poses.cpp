#include "ariadne/geometry/weighted_poses.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/core/error.h"

namespace ariadne::geometry {

void checkWeights(const std::vector<double>& weights) {
  constexpr double kRounding = 1e-6;  // far over what summing 100,000 doubles loses
  if (weights.empty()) throw core::Error("a weighted set without weights has no measures");
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(weights[i]) || weights[i] < 0)
      throw core::Error(
          fmt::format("weight {} is {}: weights are finite and 0 or more", i, weights[i]));
    sum += weights[i];
  }
  if (std::abs(sum - 1) > kRounding)
    throw core::Error(fmt::format("the weights sum to {}: normalise them to 1", sum));
}

void checkCounts(std::size_t weights, std::size_t count, const char* things) {
  if (weights != count)
    throw core::Error(
        fmt::format("{} weights for {} {}: it takes one each", weights, count, things));
}

void checkWeightedPoses(const WeightedPoses& set) {
  checkCounts(set.weights.size(), set.poses.size(), "poses");
  checkWeights(set.weights);
  for (std::size_t i = 0; i < set.poses.size(); ++i) {
    const auto& p = set.poses[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.phi))
      throw core::Error(fmt::format("pose {} of the weighted set is not finite", i));
  }
}

}  // namespace ariadne::geometry
