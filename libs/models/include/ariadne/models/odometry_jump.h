// Steps of odometry that no robot makes: odometry was reset, or the robot was carried. A log's own
// stamps may be useless, so distance decides along with speed, against the log's own steps.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <deque>
#include <optional>

namespace ariadne::models {

/// Tells steps of the odometry that no robot makes: a wheel encoder that was set back, a robot that
/// was carried.
class JumpDetector {
 public:
  /// Whether the motion to this pose from the one before is a jump:
  ///  - over 1 m (3 m where no step is known yet), over 5 times the usual step and faster than 5
  ///  m/s,
  ///  - where it ends at (0, 0, 0), which is where a reset ends: over 0.5 m and 5 times the usual
  ///  step, however long it took (where no step is known over 3 m and faster than 2 m/s); or over
  ///  30 degrees and faster than 150 degrees/s,
  ///  - or over 100 degrees and faster than 450 degrees/s.
  /// The usual step is the median of the last 50 over 1 cm. No time, or one that is not positive,
  /// says nothing about speed: distance decides, turns are believed.
  /// @param odom_from_robot m and rad
  bool operator()(const mrpt::math::TPose2D& odom_from_robot, double time_s);

 private:
  std::optional<double> usualStep_m() const;

  struct Place {
    mrpt::math::TPose2D pose;
    double time_s = 0;
  };
  std::optional<Place> before_;
  std::deque<double> steps_m_;
};

}  // namespace ariadne::models
