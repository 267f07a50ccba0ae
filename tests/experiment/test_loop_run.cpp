// The nested-loop experiment in small: one drive of 65 m with a side ring, eight particles.
#include <gtest/gtest.h>

#include <cstdlib>

#include "ariadne/experiment/loop_run.h"

using namespace ariadne;

namespace {

struct Small {
  Small() {
    const std::string data = std::string(std::getenv("ARIADNE_SOURCE_DIR")) + "/datasets/";
    world = sim::readWorld(data + "worlds/small.world");
    drive_params.max_range_m = 8;
    drive_params.scan_rate_hz = 2;
    noise.turn_per_m_deg = 0.7;
    params.filter.particles = 8;
    params.filter.weight_gain = 0.02;
    params.grid.resolution_m = 0.1;
    params.grid.no_return_free_m = 8;
    // The side ring is 13 m round.
    params.loop_closing.opportunity.c1_m = 3;
    params.loop_closing.opportunity.c2_m = 7;
    params.loop_closing.places.place_spacing_m = 1;
    params.loop_closing.places.visit_radius_m = 0.8;
    params.loop_closing.leave_after_m = 2;
    params.loop_closing.cooldown_m = 3;
    drive = sim::driveThrough(world, sim::readPath(data + "drives/small.path", 2), drive_params);
  }
  experiment::LoopRunResult run(std::uint64_t seed) const {
    return experiment::runLoop(drive, noise, params, {}, seed);
  }
  sim::World world;
  sim::DriveParams drive_params;
  sim::NoiseParams noise;
  slam::SlamParams params;
  sim::TruthDrive drive;
};

}  // namespace

TEST(LoopRun, TheForkIsTheRunWithoutRecovery) {
  Small small;
  const auto paired = small.run(3);
  ASSERT_GE(paired.recoveries, 1U);
  ASSERT_TRUE(paired.inner);
  small.params.recovery.enabled = false;
  const auto alone = small.run(3);
  EXPECT_EQ(alone.recoveries, 0U);
  EXPECT_EQ(paired.standard.ate_m, alone.recovered.ate_m) << "to the bit";
  EXPECT_EQ(paired.standard.worst_translation_m, alone.recovered.worst_translation_m);
  EXPECT_NE(paired.recovered.ate_m, paired.standard.ate_m);
}

TEST(LoopRun, IsTheSameTwice) {
  const Small small;
  const auto a = small.run(5);
  const auto b = small.run(5);
  EXPECT_EQ(a.recovered.ate_m, b.recovered.ate_m);
  EXPECT_EQ(a.standard.worst_heading_deg, b.standard.worst_heading_deg);
  EXPECT_EQ(a.inner.has_value(), b.inner.has_value());
}

TEST(LoopRun, RecoveryBringsBackWhatLapsTookAway) {
  const Small small;
  std::size_t left = 0;
  std::size_t saved = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto run = small.run(seed);
    ASSERT_TRUE(run.inner) << seed;
    left += run.inner->distinct_left;
    saved += run.inner->distinct_saved;
    EXPECT_GE(run.inner->distinct_saved, run.inner->distinct_left);
    EXPECT_LE(run.inner->kl_saved_nats, run.inner->kl_left_nats + 0.5);
    EXPECT_LE(run.inner->saved_error_m, run.inner->left_error_m + 1e-9);
  }
  EXPECT_GT(saved, left);
}
