// How far the filter believes that the robot has gone and turned.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "ariadne/geometry/pose.h"

namespace ariadne::explore {

/// Sums up how far the robot believes to have driven and turned.
class BelievedMotion {
 public:
  /// @param most_m that the robot can go between two scans: a jump of the belief is no motion
  explicit BelievedMotion(double most_m) : most_m_(most_m) {}

  /// The next pose of the belief.
  void add(const mrpt::math::TPose2D& map_from_robot) {
    if (before_) {
      travelled_m_ += std::min(geometry::distance(map_from_robot, *before_), most_m_);
      turned_rad_ += std::abs(std::remainder(map_from_robot.phi - before_->phi, 2 * M_PI));
    }
    before_ = map_from_robot;
  }
  /// Since the first pose, m.
  double travelled_m() const { return travelled_m_; }
  /// Since the first pose, left and right turns added, rad.
  double turned_rad() const { return turned_rad_; }

 private:
  double most_m_;
  std::optional<mrpt::math::TPose2D> before_;
  double travelled_m_ = 0;
  double turned_rad_ = 0;
};

}  // namespace ariadne::explore
