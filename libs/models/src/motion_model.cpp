#include "ariadne/models/motion_model.h"

#include <mrpt/core/bits_math.h>

#include <cmath>

#include "ariadne/geometry/covariance.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::models {

using mrpt::math::TPose2D;

Motion::Motion(const TPose2D& before_from_after, const MotionParams& p)
    : increment_(before_from_after) {
  const double travel = std::hypot(increment_.x, increment_.y);
  const double turn = std::abs(increment_.phi);
  if (travel > 0) direction_ = std::atan2(increment_.y, increment_.x);
  const double along = std::hypot(p.travel_per_m * travel, p.travel_per_turn_m * turn);
  const double turning =
      std::hypot(p.turn_per_turn * turn, mrpt::DEG2RAD(p.turn_per_m_deg) * std::sqrt(travel));
  sigma_ = {
      std::hypot(along, p.travel_floor_m),
      std::hypot(std::hypot(p.side_per_m * travel, p.travel_per_turn_m * turn), p.travel_floor_m),
      std::hypot(turning, mrpt::DEG2RAD(p.turn_floor_deg))};
}

TPose2D Motion::sample(const TPose2D& before, core::RandomStream& rng) const {
  if (given_) {
    const double x = rng.gaussian(), y = rng.gaussian(), turn = rng.gaussian();
    const Eigen::Matrix3d root = given_->llt().matrixL();
    const Eigen::Vector3d by = root * Eigen::Vector3d(x, y, turn);
    return geometry::compose(before,
                             {increment_.x + by[0], increment_.y + by[1], increment_.phi + by[2]});
  }
  const double along = sigma_[0] * rng.gaussian();
  const double across = sigma_[1] * rng.gaussian();
  const double turn = sigma_[2] * rng.gaussian();
  const double c = std::cos(direction_);
  const double s = std::sin(direction_);
  return geometry::compose(before, {increment_.x + c * along - s * across,
                                    increment_.y + s * along + c * across, increment_.phi + turn});
}

Eigen::Matrix3d Motion::covariance(const TPose2D& before) const {
  const Eigen::Matrix3d rotation = geometry::turnedBy(before.phi + direction_);
  if (given_) return rotation * *given_ * rotation.transpose();
  return rotation * sigma_.cwiseAbs2().asDiagonal() * rotation.transpose();
}

}  // namespace ariadne::models
