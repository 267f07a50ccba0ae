#include <gtest/gtest.h>

#include "ariadne/core/error.h"
#include "ariadne/eval/path_passes.h"

using namespace ariadne;

namespace {

/// Thrice round a square of 10 m, then 15 m straight away from it; poses only at the corners.
geometry::Trajectory rounds() {
  geometry::Trajectory path;
  const mrpt::math::TPose2D corners[] = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  for (int i = 0; i <= 12; ++i) path.push_back({10.0 * i, corners[i % 4]});
  path.push_back({135, {-15, 0, 0}});
  return path;
}

}  // namespace

TEST(PathPasses, RoundsAreCountedAlongTheWay) {
  const auto points = eval::pathPasses(rounds());
  EXPECT_NEAR(points.back().travelled_m, 135, 1e-9);
  // A second is a metre here. Away from the corners, where near_m reaches into the next side.
  EXPECT_EQ(eval::pointAt(points, 5).passes, 0U);
  EXPECT_EQ(eval::pointAt(points, 25).passes, 0U);
  EXPECT_EQ(eval::pointAt(points, 45).passes, 1U);
  EXPECT_EQ(eval::pointAt(points, 75).passes, 1U);
  EXPECT_EQ(eval::pointAt(points, 105).passes, 2U);
  EXPECT_EQ(eval::pointAt(points, 134).passes, 0U) << "new ground again";
}

TEST(PathPasses, StandingIsOnePassAndTooShortALoopIsNone) {
  geometry::Trajectory path = rounds();
  path.insert(path.begin() + 1, {5, {0.05, 0, 0}});
  path.insert(path.begin() + 2, {6, {0, 0, 0}});
  EXPECT_EQ(eval::pointAt(eval::pathPasses(path), 45).passes, 1U);
  for (const auto& point : eval::pathPasses(rounds(), {1, 200, 0.1})) EXPECT_EQ(point.passes, 0U);
}

TEST(PathPasses, WhatLiesOutsideOfTheTimeIsTheNearestEnd) {
  const auto points = eval::pathPasses(rounds());
  EXPECT_EQ(eval::pointAt(points, -100).travelled_m, 0);
  EXPECT_NEAR(eval::pointAt(points, 1e9).travelled_m, 135, 1e-9);
  EXPECT_THROW(eval::pathPasses({}), core::UsageError);
  EXPECT_THROW(eval::pathPasses(rounds(), {0, 20, 0.1}), core::UsageError);
}
