#include "ariadne/sim/senses.h"

#include <algorithm>
#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::sim {
namespace {

using core::Purpose;
using core::RandomStream;
using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;

/// A true increment as the wheels report it.
TPose2D withNoise(const TPose2D& motion, const NoiseParams& noise, RandomStream random) {
  const double distance = std::hypot(motion.x, motion.y);
  const double direction = std::atan2(motion.y, motion.x);
  const double turn_per_m = noise.turn_per_root_m_deg * M_PI / 180;
  const double turn_variance =
      noise.turn_per_root_turn * noise.turn_per_root_turn * std::abs(motion.phi) +
      turn_per_m * turn_per_m * distance;
  const double along = distance + noise.travel_per_root_m * std::sqrt(distance) * random.gaussian();
  const double across = noise.side_per_root_m * std::sqrt(distance) * random.gaussian();
  const double c = std::cos(direction), s = std::sin(direction);
  return {along * c - across * s, along * s + across * c,
          motion.phi + std::sqrt(turn_variance) * random.gaussian()};
}

/// A reading keeps to the contract of io::StepSource: valid exactly when 0 < range < maxRange.
CObservation2DRangeScan::Ptr withNoise(const CObservation2DRangeScan& clean, double sigma_m,
                                       RandomStream random) {
  auto scan = std::make_shared<CObservation2DRangeScan>(clean);
  if (sigma_m == 0) return scan;
  constexpr float kLeast_m = 0.001F;
  for (std::size_t i = 0; i < scan->getScanSize(); ++i) {
    if (!scan->getScanRangeValidity(i)) continue;
    const double noisy = scan->getScanRange(i) + sigma_m * random.gaussian();
    const float range = std::clamp(static_cast<float>(noisy), kLeast_m, scan->maxRange);
    scan->setScanRange(i, range);
    scan->setScanRangeValidity(i, range < scan->maxRange);
  }
  return scan;
}

}  // namespace

Senses::Senses(const NoiseParams& noise, std::uint64_t seed) : noise_(noise), seed_(seed) {
  core::validateFields(noise, "noise");
}

models::SensorStep Senses::next(const geometry::StampedPose& truth,
                                const CObservation2DRangeScan& clean) {
  if (step_ > 0)
    odometry_ =
        geometry::compose(odometry_, withNoise(geometry::relativePose(before_, truth.pose), noise_,
                                               RandomStream(seed_, step_, 0, Purpose::noise)));
  before_ = truth.pose;
  const auto scan =
      withNoise(clean, noise_.range_sigma_m, RandomStream(seed_, step_, 0, Purpose::range_noise));
  ++step_;
  return {truth.time_s, odometry_, scan};
}

}  // namespace ariadne::sim
