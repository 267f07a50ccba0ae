// Poses with their times, and the trajectories that they make.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace ariadne::geometry {

/// A pose and when the robot was there.
struct StampedPose {
  double time_s = 0;         ///< UNIX time, seconds
  mrpt::math::TPose2D pose;  ///< m and rad, in the frame that the trajectory names
};

/// A motion that somebody verified: the pose at time 2 seen from time 1.
struct Relation {
  double time1_s = 0;
  double time2_s = 0;
  mrpt::math::TPose2D motion;
};

/// In the order of driving. Stamps grow but where the log's clock was set back.
using Trajectory = std::vector<StampedPose>;

/// Seconds from the first pose to the last; the moments in which the clock was set back count 0.
double durationOf(const Trajectory& path);
/// Sum of the distances between successive poses, m.
double lengthOf(const Trajectory& path);
/// Poses of the same stamp stay in their order.
Trajectory sortedByTime(Trajectory path);

}  // namespace ariadne::geometry
