// Drives a robot along straight lines from waypoint to waypoint: it aims at a point a little ahead
// on the line (pure pursuit; Coulter, CMU-RI-TR-92-01, 1992), and turns on the spot where the line
// turns sharply.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <vector>

#include "ariadne/models/velocity_command.h"
#include "ariadne/sim/drive_path.h"
#include "ariadne/sim/params.h"

namespace ariadne::sim {

class Follower {
 public:
  /// `waypoints` must outlive the follower.
  Follower(const std::vector<Waypoint>& waypoints, const mrpt::math::TPose2D& start,
           const DriveParams& params);

  /// Counts the waypoints that the robot has reached.
  void see(const mrpt::math::TPose2D& robot);
  /// What to do now; stands still at the end.
  models::VelocityCommand command(const mrpt::math::TPose2D& robot);

  std::size_t reached() const { return reached_; }
  bool done() const { return reached_ == waypoints_.size(); }
  /// Time that driving from here to the next waypoint takes at most if nothing is wrong, seconds.
  double patience(const mrpt::math::TPose2D& robot) const;

 private:
  const mrpt::math::TPoint2D& target() const { return waypoints_[reached_].at; }
  mrpt::math::TPoint2D aim(const mrpt::math::TPose2D& robot) const;
  double speedTo(double distance_m) const;
  bool sharpCornerAtTarget() const;

  const std::vector<Waypoint>& waypoints_;
  DriveParams params_;
  double fastest_turn_;            // rad/s
  mrpt::math::TPoint2D leg_from_;  // where the line to the next waypoint begins
  std::size_t reached_ = 0;
  bool turning_ = false;  // on the spot
};

}  // namespace ariadne::sim
