#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/models/motion_learner.h"
#include "ariadne/models/motion_model.h"

using namespace ariadne;
using models::MotionLearner;
using models::MotionParams;
using mrpt::math::TPose2D;

namespace {

/// Steps of 0.5 m whose odometry lacks `bias` rad per m and scatters by `share` of the wide widths.
MotionLearner learned(double share, double bias, int steps, const Eigen::Vector3d& information) {
  const MotionParams wide;
  MotionLearner learner(wide);
  core::RandomStream rng(5, 0, 0, core::Purpose::test);
  const TPose2D increment(0.5, 0, 0);
  const models::Motion motion(increment, wide);
  for (int i = 0; i < steps; ++i) {
    const TPose2D matched(0.5 + share * motion.sigma()[0] * rng.gaussian(),
                          share * motion.sigma()[1] * rng.gaussian(),
                          0.5 * bias + share * motion.sigma()[2] * rng.gaussian());
    learner.add(increment, matched, {0, 0, 0}, information.asDiagonal());
  }
  return learner;
}

}  // namespace

TEST(MotionLearner, StartsAsWideAsItIsTold) {
  const MotionLearner learner{MotionParams()};
  for (const double scale : learner.scales()) EXPECT_EQ(scale, 1);
  EXPECT_EQ(learner.turnPerMetre(), 0);
  EXPECT_EQ(learner.params().turn_per_m_deg, MotionParams().turn_per_m_deg);
}

// 1.5 times the true spread is what it takes; a median of 200 steps scatters by 6 %, and the ten
// steps that the start counts for make it wider by a quarter here: bounds of three of the former.
TEST(MotionLearner, NarrowsToWhatTheLogShows) {
  const auto scales = learned(0.2, 0, 400, {1, 1, 1}).scales();
  const double expected = std::sqrt((200 * 0.3 * 0.3 + 10) / 210);
  for (const double scale : scales) EXPECT_NEAR(scale, expected, 0.05);
}

TEST(MotionLearner, LearnsAConstantTurnAndTakesItOut) {
  const double bias = 0.05;
  const auto learner = learned(0.1, bias, 400, {1, 1, 1});
  EXPECT_NEAR(learner.turnPerMetre(), bias * 200 / 230, 0.003);
  EXPECT_NEAR(learner.corrected({2, 0, 0.1}).phi, 0.1 + 2 * learner.turnPerMetre(), 1e-12);
  EXPECT_LT(learner.scales()[2], 0.5);
}

TEST(MotionLearner, ABareCorridorSaysNothingOfTheWayAlongIt) {
  const auto scales = learned(0.1, 0, 200, {0.01, 1, 1}).scales();
  EXPECT_EQ(scales[0], 1);
  EXPECT_LT(scales[1], 0.5);
}

TEST(MotionLearner, IsNeverWiderThanItIsTold) {
  for (const double scale : learned(3, 0, 200, {1, 1, 1}).scales()) EXPECT_EQ(scale, 1);
}
