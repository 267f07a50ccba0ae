// Odometry motion model p(x_t | x_{t-1}, u_t) of the filter's prediction: Gaussian in the frame of
// the robot before the motion. Noise grows with the net turn and the distance, not with the two
// rotations of rotation-translation-rotation: in a turn almost in place those are near 90 degrees
// each and would get absurd noise.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <optional>

#include "ariadne/core/random.h"
#include "ariadne/geometry/covariance.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/models/params.h"

namespace ariadne::models {

/// One odometry increment, prepared once a step, used by every particle.
class Motion {
 public:
  /// @param before_from_after odometry increment, m and rad, in the frame before the motion.
  Motion(const mrpt::math::TPose2D& before_from_after, const MotionParams& params);
  /// A motion whose noise is known otherwise.
  /// @param covariance of (x, y, heading) in the frame before the motion
  Motion(const mrpt::math::TPose2D& before_from_after, const Eigen::Matrix3d& covariance)
      : increment_(before_from_after), given_(covariance) {}

  /// Whether its noise was known otherwise.
  bool isGiven() const { return given_.has_value(); }
  /// Most likely pose after the motion.
  mrpt::math::TPose2D mean(const mrpt::math::TPose2D& before) const {
    return geometry::compose(before, increment_);
  }
  /// A pose behind `before`, drawn by the model; map frame.
  mrpt::math::TPose2D sample(const mrpt::math::TPose2D& before, core::RandomStream& rng) const;
  /// Standard deviations along and across the motion, m, and of the turn, rad.
  const Eigen::Vector3d& sigma() const { return sigma_; }
  /// Covariance of (x, y, heading), map frame, for a robot that was at `before`.
  Eigen::Matrix3d covariance(const mrpt::math::TPose2D& before) const;

 private:
  mrpt::math::TPose2D increment_;
  double direction_ = 0;                             // of travel, in the frame before
  Eigen::Vector3d sigma_ = Eigen::Vector3d::Zero();  // along, across, turn
  std::optional<Eigen::Matrix3d> given_;             // instead of these
};

}  // namespace ariadne::models
