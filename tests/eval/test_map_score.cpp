#include <gtest/gtest.h>

#include "ariadne/eval/map_score.h"

using namespace ariadne;

namespace {

using Walls = std::vector<mrpt::math::TPoint2D>;

/// A wall along y = 0 from `x0` to `x1`, in cells of 0.1 m.
Walls wall(int x0, int x1, int y = 0) {
  grid::OccupancyGrid map(grid::GridParams{0.1});
  for (int x = x0; x < x1; ++x) map.set({x, y}, -50);
  for (int x = x0; x < x1; ++x) map.set({x, y + 5}, 50);  // floor does not count
  return eval::wallsOf(map);
}

eval::MapScore scoreOf(const Walls& walls, const Walls& truth,
                       const mrpt::math::TPose2D& truth_from_map = {0, 0, 0},
                       double tolerance_m = 0.25) {
  return eval::mapScore(walls, truth, truth_from_map, tolerance_m, 0.1);
}

}  // namespace

TEST(MapScore, IsOneForTheSameMap) {
  const auto score = scoreOf(wall(0, 100), wall(0, 100));
  EXPECT_EQ(score.precision, 1);
  EXPECT_EQ(score.recall, 1);
  EXPECT_EQ(score.f1, 1);
}

TEST(MapScore, TheToleranceIsKept) {
  EXPECT_EQ(scoreOf(wall(0, 100, 2), wall(0, 100)).f1, 1);
  EXPECT_EQ(scoreOf(wall(0, 100, 3), wall(0, 100)).f1, 0);
}

TEST(MapScore, WhatIsMissingLowersTheRecallAndWhatIsTooMuchThePrecision) {
  // Half of the truth, seen also by the two cells within the tolerance.
  const auto half = scoreOf(wall(0, 50), wall(0, 100));
  EXPECT_EQ(half.precision, 1);
  EXPECT_NEAR(half.recall, 0.52, 1e-12);
  EXPECT_NEAR(half.f1, 2 * 0.52 / 1.52, 1e-12);
  const auto more = scoreOf(wall(0, 100), wall(0, 50));
  EXPECT_NEAR(more.precision, 0.52, 1e-12);
  EXPECT_EQ(more.recall, 1);
}

TEST(MapScore, TheMapIsMovedBeforeItIsCompared) {
  // A quarter turn about the origin lays the x axis on the y axis.
  Walls truth;
  for (int y = 0; y < 100; ++y) truth.emplace_back(0.05, 0.1 * y + 0.05);
  EXPECT_EQ(scoreOf(wall(0, 100), truth, {0.1, 0, M_PI / 2}, 0.1).f1, 1);
  EXPECT_LT(scoreOf(wall(0, 100), truth, {0, 0, 0}, 0.1).f1, 0.1);
}

TEST(MapScore, IsZeroWithoutWalls) {
  const Walls empty;
  EXPECT_EQ(scoreOf(empty, wall(0, 10)).f1, 0);
  EXPECT_EQ(scoreOf(wall(0, 10), empty).f1, 0);
}
