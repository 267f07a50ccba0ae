// Pairs the poses of two trajectories by time and lays one over the other.
#pragma once
#include <vector>

#include "ariadne/geometry/trajectory.h"

namespace ariadne::eval {

/// An estimated pose and the true one of the same moment, each in its own frame.
struct PosePair {
  double time_s = 0;
  mrpt::math::TPose2D estimate;
  mrpt::math::TPose2D truth;
};

/// The estimate at each of the truth's stamps: linear between the two estimated poses about it (the
/// heading along the shorter arc), where these are at most `max_gap_s` apart, or a single one
/// within max_gap_s / 2 at the ends. Both must be in time order. Truth without an estimate gives no
/// pair.
std::vector<PosePair> associate(const geometry::Trajectory& estimate,
                                const geometry::Trajectory& truth, double max_gap_s);

/// Pose of the estimate at a time, as associate() takes it. False when there is none.
bool poseAt(const geometry::Trajectory& estimate, double time_s, double max_gap_s,
            mrpt::math::TPose2D& pose);

/// truth_from_estimate that minimises the squared distances between the pairs' positions; rotation
/// and shift, no scale (Horn 1987, in the plane). Identity for no pair.
mrpt::math::TPose2D align(const std::vector<PosePair>& pairs);

}  // namespace ariadne::eval
