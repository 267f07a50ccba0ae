// The path of one hypothesis at every step, also between filter updates.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/filter/ancestry.h"
#include "ariadne/geometry/trajectory.h"

namespace ariadne::slam {

/// A processed step: its odometry, and how many filter updates there were up to it.
struct OdometryRecord {
  double time_s = 0;
  mrpt::math::TPose2D odom_from_robot;
  std::size_t updates = 0;  ///< filter updates up to and including this step; 0 before the first
  bool is_update = false;   ///< the filter was updated at this step
};

/// One pose (map_from_robot) a record. At updates it is the hypothesis' own; between two updates
/// the odometry is followed from both and blended by the share of the motion; after the last it is
/// followed on, before the first back.
geometry::Trajectory posePath(const std::vector<OdometryRecord>& records,
                              const filter::AncestorPtr& leaf);

}  // namespace ariadne::slam
