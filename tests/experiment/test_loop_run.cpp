#include <gtest/gtest.h>

#include "small_experiment.h"

using namespace ariadne;

using test::Small;

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
