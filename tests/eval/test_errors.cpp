#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/eval/errors.h"

using namespace ariadne;
using eval::PosePair;

TEST(Figures, AreTheTextbookOnes) {
  const auto f = eval::figuresOf({3, 1, 2, 6});
  EXPECT_EQ(f.count, 4U);
  EXPECT_DOUBLE_EQ(f.mean, 3);
  EXPECT_DOUBLE_EQ(f.median, 2.5);
  EXPECT_DOUBLE_EQ(f.max, 6);
  EXPECT_DOUBLE_EQ(f.rmse, std::sqrt(50.0 / 4));
  EXPECT_DOUBLE_EQ(f.deviation, std::sqrt(14.0 / 4));
  EXPECT_EQ(eval::figuresOf({}).rmse, 0);
}

TEST(Absolute, IsTheDistanceAfterLaying) {
  const std::vector<PosePair> pairs{{0, {0, 0, 0}, {1, 1, 0}}, {1, {1, 0, 0}, {1, 2.5, 0}}};
  const auto errors = eval::absoluteErrors(pairs, {1, 1, M_PI / 2});
  EXPECT_NEAR(errors[0], 0, 1e-12);
  EXPECT_NEAR(errors[1], 0.5, 1e-12);
}

TEST(Relative, SeesDriftPerDistanceAndNoRigidMotion) {
  std::vector<PosePair> pairs;
  for (int i = 0; i <= 20; ++i)  // 5 % too far, and laid elsewhere
    pairs.push_back({0.1 * i, {7, 3 + 1.05 * i, M_PI / 2}, {1.0 * i, 0, 0}});
  const auto errors = eval::relativeErrors(pairs, 4);
  EXPECT_EQ(errors.translation_m.size(), 17U);
  for (const double e : errors.translation_m) EXPECT_NEAR(e, 0.2, 1e-9);
  for (const double e : errors.rotation_deg) EXPECT_NEAR(e, 0, 1e-9);
}

TEST(Relative, AStandingRobotHasNone) {
  std::vector<PosePair> pairs(5);
  EXPECT_TRUE(eval::relativeErrors(pairs, 1).translation_m.empty());
  EXPECT_TRUE(eval::relativeErrors({}, 1).translation_m.empty());
}
