// A pose with its time: what trajectories are made of.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace ariadne::models {

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

using Trajectory = std::vector<StampedPose>;

}  // namespace ariadne::models
