#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "ariadne/core/random.h"
#include "ariadne/grid/queries/free_distance.h"
#include "corridors.h"

using namespace ariadne;
using grid::Cell;
using grid::FreeDistance;
using grid::OccupancyGrid;

namespace {

bool clear(const OccupancyGrid& map, Cell c, Cell start, double reach) {
  if (std::hypot(c.x - start.x, c.y - start.y) <= reach) return map.at(c) > 0;
  const int r = static_cast<int>(reach);
  for (int dy = -r; dy <= r; ++dy)
    for (int dx = -r; dx <= r; ++dx)
      if (std::hypot(dx, dy) <= reach && map.at({c.x + dx, c.y + dy}) <= 0) return false;
  return true;
}

/// Dijkstra with a heap and a clearance test by looking at every cell of the disc.
std::vector<std::pair<Cell, double>> brute(const OccupancyGrid& map,
                                           const mrpt::math::TPoint2D& from, double limit_m,
                                           double radius_m) {
  const double res = map.resolution();
  const Cell start = map.cellOf(from);
  const auto less = [](Cell a, Cell b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  std::map<Cell, double, decltype(less)> best(less);
  using Open = std::pair<double, std::pair<int, int>>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  best[start] = 0;
  open.push({0, {start.x, start.y}});
  while (!open.empty()) {
    const auto [d, at] = open.top();
    open.pop();
    const Cell c{at.first, at.second};
    if (d > best[c]) continue;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell n{c.x + dx, c.y + dy};
        const double l = d + res * (dx != 0 && dy != 0 ? 99.0 / 70 : 1);
        if ((dx == 0 && dy == 0) || l > limit_m + 1e-9 || !clear(map, n, start, radius_m / res))
          continue;
        const auto it = best.find(n);
        if (it != best.end() && it->second <= l + 1e-12) continue;
        best[n] = l;
        open.push({l, {n.x, n.y}});
      }
  }
  return {best.begin(), best.end()};
}

}  // namespace

TEST(FreeDistance, IsThatOfBruteForceInRandomMaps) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    core::RandomStream rng(seed, 0, 0, core::Purpose::test);
    OccupancyGrid map;
    test::drawRoom(map, -3, -2, 3, 2);
    for (int i = 0; i < 60; ++i) {
      const Cell c = map.cellOf({6 * rng.uniform() - 3, 4 * rng.uniform() - 2});
      if (std::hypot(c.x, c.y) > 3) map.set(c, i % 3 == 0 ? 0 : -50);
    }
    const double radius = 0.05 * (seed % 4);
    const FreeDistance fast(map, {0, 0}, 2.5, radius);
    std::size_t reached = 0;
    for (const auto& [cell, length] : brute(map, {0, 0}, 2.5, radius)) {
      const auto d = fast.to(map.centreOf(cell));
      ASSERT_TRUE(d) << cell.x << ' ' << cell.y;
      EXPECT_NEAR(*d, length, 1e-9);
      ++reached;
    }
    std::size_t found = 0;
    for (int y = -80; y <= 80; ++y)
      for (int x = -80; x <= 80; ++x) found += fast.to(map.centreOf({x, y})).has_value();
    EXPECT_EQ(found, reached);
    EXPECT_GT(reached, 300U);
  }
}

TEST(FreeDistance, WallsJustPastTheLimitKeepTheirClearance) {
  OccupancyGrid map;
  test::drawRoom(map, -2, -2, 2, 2);
  const double limit = 1.8;  // up to 0.2 m from the walls
  const FreeDistance d(map, {0, 0}, limit, 0.25);
  std::size_t reached = 0;
  for (const auto& [cell, length] : brute(map, {0, 0}, limit, 0.25)) {
    EXPECT_TRUE(d.to(map.centreOf(cell))) << cell.x << ' ' << cell.y;
    ++reached;
  }
  std::size_t found = 0;
  for (int y = -50; y <= 50; ++y)
    for (int x = -50; x <= 50; ++x) found += d.to(map.centreOf({x, y})).has_value();
  EXPECT_EQ(found, reached);
}

TEST(FreeDistance, ToGivenTargetsIsTheSameInASmallerWindow) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    core::RandomStream rng(seed, 1, 0, core::Purpose::test);
    OccupancyGrid map;
    test::drawRoom(map, -4, -4, 4, 4);
    for (int i = 0; i < 150; ++i) {
      const Cell c = map.cellOf({8 * rng.uniform() - 4, 8 * rng.uniform() - 4});
      if (std::hypot(c.x, c.y) > 6) map.set(c, i % 3 == 0 ? 0 : -50);
    }
    const double radius = 0.05 * (seed % 6);
    std::vector<mrpt::math::TPoint2D> targets;
    for (std::uint32_t i = 0; i <= seed % 3; ++i)
      targets.push_back({6 * rng.uniform() - 3, 6 * rng.uniform() - 3});
    const FreeDistance whole(map, {0.1, -0.2}, 3, radius);
    const FreeDistance part(map, {0.1, -0.2}, 3, radius, targets);
    for (const auto& to : targets) {
      EXPECT_EQ(part.to(to), whole.to(to)) << seed;
      const auto place = whole.toPlace(to);
      if (!place || *place <= 3) {
        EXPECT_EQ(part.toPlace(to), place) << seed;
      }
    }
  }
}

TEST(FreeDistance, GoesRoundTheBlock) {
  const auto map = test::ringMap(8);
  const FreeDistance d(map, {0, 0}, 20, 0.2);
  const auto across = d.to({8, 8});
  ASSERT_TRUE(across);
  EXPECT_GT(*across, 13);  // corners are cut, walls are not
  EXPECT_LT(*across, 16);
  EXPECT_FALSE(d.to({4, 4})) << "rock";
  EXPECT_FALSE(FreeDistance(map, {0, 0}, 10, 0.2).to({8, 8})) << "past the limit";
}

TEST(FreeDistance, ARobotTooNearToAWallMayLeave) {
  const auto map = test::ringMap(8);
  const FreeDistance d(map, {0, -0.95}, 5, 0.3);
  EXPECT_TRUE(d.to({2, 0}));
  EXPECT_FALSE(d.to({2, -0.95}));
  EXPECT_TRUE(d.toPlace({2, -0.85})) << "a robot has been there";
}

TEST(FreeDistance, InUnknownSpaceNothingIsReached) {
  const OccupancyGrid map;
  const FreeDistance d(map, {0, 0}, 5, 0.2);
  EXPECT_FALSE(d.to({1, 0}));
}
