// The odometry as the mapper follows it: without its jumps, and with how far it may be off by now.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <optional>

#include "ariadne/models/params.h"
#include "ariadne/models/sensor_step.h"

namespace ariadne::slam {

/// Why the odometry since the last update is not to be taken as usual.
struct Doubt {
  /// What the odometry itself says of the motion, jump and all; set where it jumped.
  std::optional<mrpt::math::TPose2D> claimed;
  double gap_s = 0;  ///< longest time between the two steps of a jump
  /// Of the motion that was driven blind, in the frame of the last update; 0 where there was none.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool blind = false;
};

class DeadReckoning {
 public:
  explicit DeadReckoning(const models::MotionParams& motion) : motion_(motion) {}

  /// Where the odometry has the robot at this step. Where it jumped the robot is taken to have gone
  /// on as in the step before.
  mrpt::math::TPose2D add(const models::SensorStep& step);
  /// A scan was due here that showed nothing. After 1 m or 60 degrees of that the motion is in
  /// doubt.
  void passBlind();
  /// An update was made here: what comes is counted from it. `here` may be another pose than add()
  /// gave, where a scan told better.
  void update(const mrpt::math::TPose2D& here);

  /// The motion since the last update.
  mrpt::math::TPose2D sinceUpdate() const;
  /// Where another motion since the last update would have led.
  mrpt::math::TPose2D afterUpdate(const mrpt::math::TPose2D& motion) const;
  const std::optional<Doubt>& doubt() const { return doubt_; }

 private:
  mrpt::math::TPose2D throughJump(double time_s) const;

  models::MotionParams motion_;
  std::optional<models::SensorStep> last_;  // without its scan
  mrpt::math::TPose2D last_motion_;
  double last_motion_s_ = 0;
  bool corrected_ = false;
  mrpt::math::TPose2D here_from_odom_;  // once the odometry has jumped
  mrpt::math::TPose2D here_;
  mrpt::math::TPose2D at_update_;
  mrpt::math::TPose2D at_part_;
  std::optional<Doubt> doubt_;
};

}  // namespace ariadne::slam
