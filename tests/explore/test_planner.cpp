#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "ariadne/explore/planner.h"
#include "drawn_map.h"

using namespace ariadne;
using explore::ExploreParams;
using explore::Planner;
using explore::PlanningGrid;
using mrpt::math::TPoint2D;

namespace {

// Letters of 0.5 m: two rooms, a wide door above and a crack of one letter below.
const std::vector<std::string> kRooms{"################",  //
                                      "#......#.......#",  //
                                      "#..............#",  //
                                      "#..............#",  //
                                      "#......#.......#",  //
                                      "#......#.......#",  //
                                      "################"};

std::shared_ptr<const PlanningGrid> gridOf(const std::vector<std::string>& rows, int scale,
                                           const std::vector<TPoint2D>& obstacles = {}) {
  return std::make_shared<PlanningGrid>(test::drawnMap(rows, scale), 0.1, obstacles);
}

/// Without buckets and shortcuts: the yardstick.
std::vector<double> lengthsByQueue(const Planner& p, int start) {
  const PlanningGrid& g = p.grid();
  std::vector<double> best(static_cast<std::size_t>(g.size()), 1e9);
  std::priority_queue<std::pair<double, int>> queue;
  best[start] = 0;
  queue.push({0, start});
  while (!queue.empty()) {
    const auto [minus, i] = queue.top();
    queue.pop();
    if (-minus > best[i]) continue;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int j = i + dy * g.width() + dx;
        const double d = -minus + std::hypot(dx, dy) * g.cell_m();
        if (j == i || !p.open(j) || d >= best[j]) continue;
        best[j] = d;
        queue.push({-d, j});
      }
  }
  return best;
}

}  // namespace

TEST(Planner, WithoutPreferenceWaysAreTheShortest) {
  ExploreParams params;
  params.preferred_clearance_m = 0;
  const auto grid = gridOf(kRooms, 10);
  const Planner planner(grid, {1.2, 1.2}, params);
  const auto lengths = lengthsByQueue(planner, grid->indexOf({1.2, 1.2}));
  int reached = 0;
  for (int i = 0; i < grid->size(); ++i) {
    ASSERT_EQ(planner.reaches(i), lengths[i] < 1e9) << i;
    if (!planner.reaches(i)) continue;
    ++reached;
    // 99 / 70 for the square root of two: 1e-4 of the length.
    EXPECT_NEAR(planner.length(i), lengths[i], 2e-4 * lengths[i] + 1e-9);
  }
  EXPECT_GT(reached, 1000);
}

TEST(Planner, RoutesStepFromCellToCellKeepClearAndEndWhereTheyShould) {
  const ExploreParams params;
  const auto grid = gridOf(kRooms, 10);
  const Planner planner(grid, {1.2, 1.2}, params);
  const int goal = grid->indexOf({6.2, 1.2});
  ASSERT_TRUE(planner.reaches(goal));
  const explore::Route route = planner.routeTo(goal);
  EXPECT_EQ(grid->indexOf(route.front()), grid->indexOf({1.2, 1.2}));
  EXPECT_EQ(grid->indexOf(route.back()), goal);
  double length = 0;
  for (std::size_t k = 0; k < route.size(); ++k) {
    EXPECT_GE(grid->wallDistance(grid->indexOf(route[k])),
              params.robot_radius_m + params.clearance_m);
    if (k > 0) {
      const double step = std::hypot(route[k].x - route[k - 1].x, route[k].y - route[k - 1].y);
      EXPECT_LE(step, 0.1 * std::sqrt(2) + 1e-9);
      length += step;
    }
  }
  EXPECT_NEAR(planner.length(goal), length, 1e-3);
}

TEST(Planner, AHoleNarrowerThanTheRobotIsNoWay) {
  // Letters of 0.3 m: the only opening is one letter, under the diameter of 0.4 m.
  const std::vector<std::string> rows{"#########",  //
                                      "#...#...#",  //
                                      "#.......#",  //
                                      "#...#...#",  //
                                      "#########"};
  const auto grid = gridOf(rows, 6);
  const Planner planner(grid, {0.75, 0.75}, {});
  EXPECT_FALSE(planner.reaches(grid->indexOf({1.95, 0.75})));
  ExploreParams slim;
  slim.robot_radius_m = 0.05;
  slim.clearance_m = 0;
  EXPECT_TRUE(Planner(grid, {0.75, 0.75}, slim).reaches(grid->indexOf({1.95, 0.75})));
}

TEST(Planner, AStartBesideAWallCanBeLeft) {
  const auto grid = gridOf(kRooms, 10);
  const TPoint2D beside{0.58, 1.2};
  const Planner planner(grid, beside, {});
  EXPECT_TRUE(planner.reaches(grid->indexOf({3, 1.2})));
}

TEST(Planner, OutsideTheMapNothingIsReached) {
  const auto grid = gridOf(kRooms, 10);
  const Planner planner(grid, {-50, 0}, {});
  for (int i = 0; i < grid->size(); ++i) EXPECT_FALSE(planner.reaches(i));
}
