#include "ariadne/models/motion_learner.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/covariance.h"
#include "ariadne/models/motion_model.h"
#include "ariadne/models/proposal.h"

namespace ariadne::models {
namespace {

using mrpt::math::TPose2D;

constexpr double kSafety = 1.5;  // odometry slips now and then, which a fit to most does not see
constexpr double kNarrowest = 0.1;
constexpr double kLeastTravel_m = 0.05;
constexpr double kStraight_rad = 0.2;

}  // namespace

MotionLearner::MotionLearner(const MotionParams& wide)
    : wide_(wide),
      fits_{OffsetFit(wide.travel_per_m), OffsetFit(0),
            OffsetFit(mrpt::DEG2RAD(wide.turn_per_m_deg))} {}

// The matched pose is where g H (z - m) = Q^-1 (m - o): from odometry's o, its covariance Q, the
// scan's information H and the gain g follows z, what the scan alone says.
void MotionLearner::add(const TPose2D& increment, const TPose2D& matched, const TPose2D& before,
                        const Eigen::Matrix3d& information, double match_gain) {
  const double travel = std::hypot(increment.x, increment.y);
  if (travel < kLeastTravel_m || !(information(2, 2) > 0)) return;
  ++steps_;
  const TPose2D mean = corrected(increment);
  const double direction = std::atan2(increment.y, increment.x);
  const Eigen::Matrix3d to_motion = geometry::turnedBy(-(before.phi + direction));
  const Eigen::Matrix3d spread =
      (to_motion * information * to_motion.transpose() + 1e-3 * Eigen::Matrix3d::Identity())
          .inverse();
  const Eigen::Vector3d by_match =
      geometry::turnedBy(-direction) *
      Eigen::Vector3d(matched.x - mean.x, matched.y - mean.y,
                      std::remainder(matched.phi - mean.phi, 2 * M_PI));
  const Eigen::Vector3d believed = Motion(mean, params()).sigma().cwiseAbs2();
  Eigen::Vector3d off =
      by_match + spread / match_gain * believed.cwiseInverse().asDiagonal() * by_match;
  off[0] += std::hypot(mean.x, mean.y) - travel;
  off[2] += std::remainder(mean.phi - increment.phi, 2 * M_PI);
  const Eigen::Vector3d wide = Motion(increment, wide_).sigma().cwiseAbs2();
  for (int i = 0; i < 3; ++i) {
    if (i == 2 && std::abs(increment.phi) > kStraight_rad) continue;
    fits_[static_cast<std::size_t>(i)].add(
        {off[i], travel, wide[i], spread(i, i) / kCalibratedGain});
  }
}

std::array<double, 3> MotionLearner::scales() const {
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = steps_ == 0 ? 1 : std::clamp(kSafety * fits_[i].scale(), kNarrowest, 1.0);
  return out;
}

MotionParams MotionLearner::params() const {
  const auto [along, across, turn] = scales();
  MotionParams p = wide_;
  p.travel_per_m *= along;
  p.travel_per_turn_m *= std::max(along, across);
  p.side_per_m *= across;
  p.turn_per_turn *= turn;
  p.turn_per_m_deg *= turn;
  return p;
}

TPose2D MotionLearner::corrected(const TPose2D& increment) const {
  const double turn = turnPerMetre() * std::hypot(increment.x, increment.y);
  const double longer = 1 + stretch();
  return {longer * increment.x, longer * increment.y,
          std::remainder(increment.phi + turn, 2 * M_PI)};
}

}  // namespace ariadne::models
