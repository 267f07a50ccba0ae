// The path of one hypothesis by filter update, with the scans taken on it: what closures are
// searched on.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <vector>

#include "ariadne/filter/ancestry.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/grid/insertion/scan_shape.h"

namespace ariadne::loops {

/// Ends of a scan's beams, m, robot's frame, in beam order.
using ScanHits = std::vector<mrpt::math::TPoint2D>;

/// The path of a hypothesis with how each of its motions was known.
struct Track {
  std::vector<mrpt::math::TPose2D> poses;  ///< map_from_robot, one per update
  std::vector<double> travelled_m;         ///< distance from the beginning, one per update
  /// Of the motion to each update: (x, y, heading) in the frame before it; the first counts
  /// nothing.
  std::vector<Eigen::Matrix3d> motion_covariance;
  /// To each update from the one before, robot's frame, as the filter drew it, before any closure
  /// bent the path; the first counts nothing.
  std::vector<mrpt::math::TPose2D> motions;
  /// The last update.
  std::size_t now() const { return poses.size() - 1; }
};

/// The line of `leaf`, whose updates count from 0.
/// @param motion_covariance of all updates up to the leaf's at the least, or empty
Track trackOf(const filter::AncestorPtr& leaf,
              const std::vector<Eigen::Matrix3d>& motion_covariance);

}  // namespace ariadne::loops
