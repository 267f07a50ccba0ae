#include <gtest/gtest.h>

#include "ariadne/eval/map_score.h"

using namespace ariadne;

namespace {

/// A wall along y = 0 from `x0` to `x1`, in cells of 0.1 m.
grid::OccupancyGrid wall(int x0, int x1, int y = 0) {
  grid::GridParams params;
  params.resolution_m = 0.1;
  grid::OccupancyGrid map(params);
  for (int x = x0; x < x1; ++x) map.set({x, y}, -50);
  for (int x = x0; x < x1; ++x) map.set({x, y + 5}, 50);  // floor does not count
  return map;
}

}  // namespace

TEST(MapScore, IsOneForTheSameMap) {
  const auto score = eval::mapScore(wall(0, 100), wall(0, 100), {0, 0, 0}, 0.25);
  EXPECT_EQ(score.precision, 1);
  EXPECT_EQ(score.recall, 1);
  EXPECT_EQ(score.f1, 1);
}

TEST(MapScore, TheToleranceIsKept) {
  EXPECT_EQ(eval::mapScore(wall(0, 100, 2), wall(0, 100), {0, 0, 0}, 0.25).f1, 1);
  EXPECT_EQ(eval::mapScore(wall(0, 100, 3), wall(0, 100), {0, 0, 0}, 0.25).f1, 0);
}

TEST(MapScore, WhatIsMissingLowersTheRecallAndWhatIsTooMuchThePrecision) {
  // Half of the truth, seen also by the two cells within the tolerance.
  const auto half = eval::mapScore(wall(0, 50), wall(0, 100), {0, 0, 0}, 0.25);
  EXPECT_EQ(half.precision, 1);
  EXPECT_NEAR(half.recall, 0.52, 1e-12);
  EXPECT_NEAR(half.f1, 2 * 0.52 / 1.52, 1e-12);
  const auto more = eval::mapScore(wall(0, 100), wall(0, 50), {0, 0, 0}, 0.25);
  EXPECT_NEAR(more.precision, 0.52, 1e-12);
  EXPECT_EQ(more.recall, 1);
}

TEST(MapScore, TheMapIsMovedBeforeItIsCompared) {
  // A quarter turn about the origin lays the x axis on the y axis.
  grid::OccupancyGrid truth(grid::GridParams{0.1});
  for (int y = 0; y < 100; ++y) truth.set({0, y}, -50);
  EXPECT_EQ(eval::mapScore(wall(0, 100), truth, {0.1, 0, M_PI / 2}, 0.1).f1, 1);
  EXPECT_LT(eval::mapScore(wall(0, 100), truth, {0, 0, 0}, 0.1).f1, 0.1);
}

TEST(MapScore, IsZeroWithoutWalls) {
  const grid::OccupancyGrid empty(grid::GridParams{0.1});
  EXPECT_EQ(eval::mapScore(empty, wall(0, 10), {0, 0, 0}, 0.25).f1, 0);
  EXPECT_EQ(eval::mapScore(wall(0, 10), empty, {0, 0, 0}, 0.25).f1, 0);
}
