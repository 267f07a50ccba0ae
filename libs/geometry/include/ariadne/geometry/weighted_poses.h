// A belief about the robot's pose as the filter holds it: poses and their normalised weights.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <cstddef>
#include <vector>

namespace ariadne::geometry {

/// A distribution over poses as samples with weights.
struct WeightedPoses {
  std::vector<mrpt::math::TPose2D> poses;  ///< m and rad, all in one frame
  std::vector<double> weights;             ///< one a pose, summing to 1
};

/// Throws core::Error when there is no weight, one is negative or not finite, or their sum is off 1
/// by more than 1e-6.
void checkWeights(const std::vector<double>& weights);

/// As checkWeights(); also when there are not as many weights as poses, or a pose is not finite.
void checkWeightedPoses(const WeightedPoses& set);

/// Throws core::Error when `weights`, the number of weights of `things`, is not `count`.
void checkCounts(std::size_t weights, std::size_t count, const char* things);

}  // namespace ariadne::geometry
