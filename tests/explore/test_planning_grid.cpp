#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ariadne/explore/planning_grid.h"
#include "drawn_map.h"

using namespace ariadne;
using explore::CellKind;
using explore::PlanningGrid;

namespace {

// Letters of 0.2 m.
const std::vector<std::string> kRoom{"##########",  //
                                     "#........#",  //
                                     "#...#.... ",  //
                                     "#........#",  //
                                     "##########"};

}  // namespace

TEST(PlanningGrid, CoarseCellsAreWhatMostOfTheirCellsAreAndWallsWin) {
  grid::OccupancyGrid map = test::drawnMap(kRoom, 4);
  map.set({10, 6}, -50);  // one cell of a coarse one
  const PlanningGrid g(map, 0.1, {});
  EXPECT_NEAR(g.cell_m(), 0.1, 1e-12);
  EXPECT_EQ(g.kind(g.indexOf({0.1, 0.1})), CellKind::occupied);
  EXPECT_EQ(g.kind(g.indexOf({0.3, 0.3})), CellKind::free);
  EXPECT_EQ(g.kind(g.indexOf({10.5 * 0.05, 6.5 * 0.05})), CellKind::occupied);
  EXPECT_EQ(g.kind(g.indexOf({1.9, 0.5})), CellKind::unknown);
  EXPECT_EQ(g.indexOf({-5, 0}), -1);
  EXPECT_EQ(g.indexOf({std::nan(""), 0}), -1);
}

TEST(PlanningGrid, PointsComeBackFromTheirCells) {
  const PlanningGrid g(test::drawnMap(kRoom, 4), 0.1, {});
  for (int i = 0; i < g.size(); ++i)
    if (g.kind(i) != CellKind::unknown) {
      EXPECT_EQ(g.indexOf(g.centreOf(i)), i);
    }
}

TEST(PlanningGrid, DistancesAreThoseOfABruteForceSearch) {
  const PlanningGrid g(test::drawnMap(kRoom, 4), 0.1, {});
  for (int i = 0; i < g.size(); ++i) {
    if (g.kind(i) != CellKind::free) continue;
    double nearest = 1e9;
    for (int j = 0; j < g.size(); ++j)
      if (g.kind(j) == CellKind::occupied)
        nearest = std::min(nearest, std::hypot(g.centreOf(i).x - g.centreOf(j).x,
                                               g.centreOf(i).y - g.centreOf(j).y));
    EXPECT_GE(g.wallDistance(i), 0.93 * nearest) << i;
    EXPECT_LE(g.wallDistance(i), 1.09 * nearest) << i;
  }
}

TEST(PlanningGrid, ObstaclesAreOccupiedWhateverTheMapSays) {
  const PlanningGrid g(test::drawnMap(kRoom, 4), 0.1, {{0.5, 0.5}, {99, 99}});
  EXPECT_EQ(g.kind(g.indexOf({0.5, 0.5})), CellKind::occupied);
}

TEST(PlanningGrid, WallsBlockTheViewBothWays) {
  const PlanningGrid g(test::drawnMap(kRoom, 4), 0.1, {});
  const int left = g.indexOf({0.5, 0.5});
  const int right = g.indexOf({1.3, 0.5});
  EXPECT_FALSE(g.sees(left, right));
  EXPECT_FALSE(g.sees(right, left));
  EXPECT_TRUE(g.sees(g.indexOf({0.5, 0.3}), g.indexOf({1.3, 0.3})));
}

TEST(PlanningGrid, AnEmptyMapHasNoCellToStandIn) {
  const PlanningGrid g(grid::OccupancyGrid{}, 0.1, {});
  for (int i = 0; i < g.size(); ++i) EXPECT_EQ(g.kind(i), CellKind::unknown);
}
