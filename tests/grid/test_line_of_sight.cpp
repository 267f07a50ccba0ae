#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "ariadne/core/random.h"
#include "ariadne/grid/queries/line_of_sight.h"

using namespace ariadne;
using grid::Cell;
using grid::OccupancyGrid;
using mrpt::math::TPoint2D;

TEST(Traverse, VisitsEveryCellThatSamplesOfTheLineLieIn) {
  OccupancyGrid map;
  core::RandomStream rng(8, 0, 0, core::Purpose::test);
  for (int trial = 0; trial < 200; ++trial) {
    const TPoint2D a(rng.gaussian(), rng.gaussian());
    const TPoint2D b(rng.gaussian(), trial % 10 == 0 ? a.y : rng.gaussian());
    std::set<std::pair<int, int>> visited;
    Cell last{};
    grid::traverse(map, a, b, [&](Cell c) {
      if (!visited.empty()) {
        EXPECT_EQ(std::abs(c.x - last.x) + std::abs(c.y - last.y), 1) << "not a neighbour";
      }
      EXPECT_TRUE(visited.insert({c.x, c.y}).second) << "twice";
      last = c;
      return true;
    });
    EXPECT_EQ(map.cellOf(b).x, last.x);
    EXPECT_EQ(map.cellOf(b).y, last.y);
    std::size_t missed = 0;
    for (int i = 0; i <= 1000; ++i) {
      const Cell c = map.cellOf(a + (b - a) * (i / 1000.0));
      missed += visited.count({c.x, c.y}) == 0;
    }
    EXPECT_EQ(missed, 0U);
  }
}

TEST(LineOfSight, WallsAndUnknownBlock) {
  OccupancyGrid map;
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y) map.set({x, y}, 30);
  EXPECT_TRUE(grid::inSight(map, {0.1, 0.1}, {1.9, 1.5}));
  EXPECT_FALSE(grid::inSight(map, {0.1, 0.1}, {2.5, 0.1}));  // leaves the known part
  for (int y = 0; y < 40; ++y) map.set({20, y}, -30);
  EXPECT_FALSE(grid::inSight(map, {0.1, 0.1}, {1.9, 1.5}));
}
