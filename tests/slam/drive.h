// A drive through the room of room.h with noisy odometry, as a list of steps.
#pragma once
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/models/sensor_step.h"
#include "room.h"

namespace ariadne::test {

struct RecordedDrive {
  std::vector<models::SensorStep> steps;
  std::vector<mrpt::math::TPose2D> truth;  // world frame
};

/// Laps on an oval, 0.1 m a step; the odometry turns 3 % too far and slips 2 %.
inline RecordedDrive ovalDrive(int steps, std::uint64_t seed = 1) {
  const auto world = roomWorld();
  RecordedDrive drive;
  mrpt::math::TPose2D truth(-1.5, -1, 0);
  mrpt::math::TPose2D odom(0, 0, 0);
  core::RandomStream rng(seed, 0, 0, core::Purpose::noise);
  for (int i = 0; i < steps; ++i) {
    if (i > 0) {
      const double turn = i % 50 < 25 ? 0 : M_PI / 25;
      truth = geometry::compose(truth, {0.1, 0, turn});
      odom = geometry::compose(odom, {0.102 + 0.002 * rng.gaussian(), 0.001 * rng.gaussian(),
                                      1.03 * turn + 0.003 * rng.gaussian()});
    }
    drive.truth.push_back(truth);
    drive.steps.push_back({1000 + 0.2 * i, odom, scanIn(world, truth)});
  }
  return drive;
}

}  // namespace ariadne::test
