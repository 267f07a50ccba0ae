// What the robot touched: walls from then on, whatever the map says.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace ariadne::explore {

/// Remembers where the robot touched something that its laser does not show.
class Bumper {
 public:
  /// Points lie 5 cm beyond the robot's rim.
  explicit Bumper(double robot_radius_m) : rim_m_(robot_radius_m + 0.05) {}

  /// Something stands before the robot, within 40 degrees of its nose.
  void touch(const mrpt::math::TPose2D& map_from_robot);
  /// Points of what was touched, m, map frame.
  const std::vector<mrpt::math::TPoint2D>& points() const { return points_; }
  /// How often the bumper was pressed.
  int touches() const { return touches_; }

 private:
  double rim_m_;
  std::vector<mrpt::math::TPoint2D> points_;
  int touches_ = 0;
};

}  // namespace ariadne::explore
