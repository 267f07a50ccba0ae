// The true path of a run, where somebody knows it.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <cstddef>
#include <optional>

#include "ariadne/geometry/trajectory.h"

namespace ariadne::slam_app {

/// The truth laid over the path of s* by the rotation and shift that minimise the squared
/// distances, as ariadne-eval does.
struct TruthFit {
  geometry::Trajectory truth;  ///< truth_from_robot
  mrpt::math::TPose2D map_from_truth;
  double ate_rmse_m = 0;
  std::size_t poses = 0;  ///< true poses at which the path has one
};

/// True poses count where the path has poses at most so far apart about them, s.
constexpr double kTruthGap_s = 1;

/// Nothing when the two have no time in common.
std::optional<TruthFit> fitTruth(const geometry::Trajectory& path, geometry::Trajectory truth);

}  // namespace ariadne::slam_app
