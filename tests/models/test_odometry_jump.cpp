#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/models/odometry_jump.h"

using ariadne::models::JumpDetector;
using mrpt::math::TPose2D;

namespace {

/// Has driven 5 m to (5, 2, 1) in steps of 0.1 m, 0.2 s each; the next stamp is 10.2.
JumpDetector driven(double step_m = 0.1, double step_s = 0.2) {
  JumpDetector jumped;
  for (int i = 50; i >= 0; --i) EXPECT_FALSE(jumped({5 - step_m * i, 2, 1}, 10 - step_s * i));
  return jumped;
}

}  // namespace

TEST(OdometryJump, AResetOrALeapIsOne) {
  EXPECT_TRUE(driven()({0, 0, 0}, 10.2));
  EXPECT_TRUE(driven()({6.2, 2, 1}, 10.2));
  EXPECT_TRUE(driven()({5, 2, 1 - M_PI}, 10.2));
}

TEST(OdometryJump, FastRobotsJumpNot) {
  EXPECT_FALSE(driven()({5.9, 2, 1}, 10.2));     // 4.5 m/s, as in the log of MIT CSAIL
  EXPECT_FALSE(driven()({5, 2, 2.6}, 10.2));     // 92 degrees in 0.2 s
  EXPECT_FALSE(driven()({9, 2, 1}, 12));         // 4 m, but in 2 s
  EXPECT_FALSE(driven()({5, 2, 1 - M_PI}, 11));  // 180 degrees/s
}

TEST(OdometryJump, GoesByTheLogsOwnSteps) {
  // Keyframes a metre apart whose stamps are all the same.
  EXPECT_FALSE(driven(1, 0)({8, 2, 1}, 10));
  EXPECT_TRUE(driven(1, 0)({11, 2, 1}, 10));
  // A car.
  EXPECT_FALSE(driven(1.5, 0.1)({6.6, 2, 1}, 10.1));
}

TEST(OdometryJump, ASmallResetEndsAtHome) {
  JumpDetector jumped;
  for (int i = 0; i <= 30; ++i) EXPECT_FALSE(jumped({-0.1 + 0.03 * i, 0, 0.2}, 0.2 * i));
  EXPECT_FALSE(jumped({0.1, 0, 0.2}, 6.2));  // 0.7 m to another place in 0.2 s: less than 5 m/s
  JumpDetector other;
  for (int i = 0; i <= 30; ++i) EXPECT_FALSE(other({-0.1 + 0.03 * i, 0, 0.2}, 0.2 * i));
  EXPECT_TRUE(other({0, 0, 0}, 6.2));
}

TEST(OdometryJump, AResetAfterAGapIsOneHoweverSlowItLooks) {
  EXPECT_TRUE(driven()({0, 0, 0}, 25));  // 5.4 m in 15 s
  EXPECT_TRUE(driven()({0.02, 0, 0.01}, 4000));
  EXPECT_FALSE(driven()({1, 0, 0}, 25));  // elsewhere: the robot may have driven there
}

TEST(OdometryJump, AResetInMidTurnNearHome) {
  const auto turning = [](double to_rad) {
    JumpDetector jumped;
    for (int i = 0; i <= 10; ++i)
      EXPECT_FALSE(jumped({0.1, 0.01 * i, to_rad - 0.1 * (10 - i)}, 0.2 * i));
    return jumped;
  };
  EXPECT_TRUE(turning(0.9)({0, 0, 0}, 2.2));
  EXPECT_FALSE(turning(0.4)({0, 0, 0}, 2.2));  // 115 degrees/s: a quick robot
  EXPECT_FALSE(turning(0.9)({0, 0, 0}, 4));
}

TEST(OdometryJump, StampsThatRepeatOrGoBackSayNothingOfSpeed) {
  EXPECT_FALSE(driven()({5.3, 2, 1}, 10));
  EXPECT_TRUE(driven()({7, 2, 1}, 10));
  EXPECT_TRUE(driven()({7, 2, 1}, 3));
  EXPECT_FALSE(driven()({5, 2, 1 - M_PI}, 10));
}

TEST(OdometryJump, TheFirstStepMayBeLong) {
  JumpDetector jumped;
  EXPECT_FALSE(jumped({1, 2, 3}, 5));
  EXPECT_FALSE(jumped({3, 2, 3}, 5.1));
  JumpDetector other;
  other({1, 2, 3}, 5);
  EXPECT_TRUE(other({5, 2, 3}, 5.1));
}

TEST(OdometryJump, WhatFollowsAJumpIsJudgedAnew) {
  JumpDetector jumped = driven();
  EXPECT_TRUE(jumped({0, 0, 0}, 10.2));
  EXPECT_FALSE(jumped({0.1, 0, 0}, 10.4));
  EXPECT_TRUE(jumped({5.2, 2, 1}, 10.6));  // one wrong reading: there and back
}
