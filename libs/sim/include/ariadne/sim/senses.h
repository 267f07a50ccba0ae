// What the robot's sensors say of what truly happens, one step after the other.
#pragma once
#include <cstdint>

#include "ariadne/geometry/trajectory.h"
#include "ariadne/models/sensor_step.h"
#include "ariadne/sim/params.h"

namespace ariadne::sim {

/// What the robot's sensors say of the truth, with the noise of a seed.
class Senses {
 public:
  /// Throws core::UsageError when a parameter is out of bounds.
  Senses(const NoiseParams& noise, std::uint64_t seed);

  /// The next step; odometry starts at the origin. The k-th step's draws depend on (seed, k) only:
  /// same seed, same bits. A beam that noise takes beyond the maximum range has no return.
  /// @param truth world_from_robot
  models::SensorStep next(const geometry::StampedPose& truth,
                          const mrpt::obs::CObservation2DRangeScan& clean);

 private:
  NoiseParams noise_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  mrpt::math::TPose2D before_;  // true pose of the last step
  mrpt::math::TPose2D odometry_;
};

}  // namespace ariadne::sim
