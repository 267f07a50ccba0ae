#include <gtest/gtest.h>

#include <algorithm>

#include "ariadne/explore/frontiers.h"
#include "drawn_map.h"

using namespace ariadne;
using explore::ExploreParams;
using explore::Frontier;
using explore::Planner;
using explore::PlanningGrid;
using mrpt::math::TPoint2D;

namespace {

// Letters of 0.5 m: a room with an opening to the right and one, farther away, to the left; a slit
// of unknown within the wall above.
const std::vector<std::string> kOpenings{"####################",   //
                                         "#..................#",   //
                                         "#..................#",   //
                                         " ................... ",  //
                                         " ................... ",  //
                                         "#..................#",   //
                                         "####################"};

Planner plannerOf(const grid::OccupancyGrid& map, const TPoint2D& robot,
                  const std::vector<TPoint2D>& obstacles = {}) {
  return Planner(std::make_shared<PlanningGrid>(map, 0.1, obstacles), robot, {});
}

}  // namespace

TEST(Frontiers, AreWhereFreeBordersOnUnknown) {
  const auto map = test::drawnMap(kOpenings, 10);
  const Planner planner = plannerOf(map, {7, 1.75});
  const auto frontiers = findFrontiers(planner, {}, {});
  ASSERT_EQ(frontiers.size(), 2U);
  for (const Frontier& f : frontiers) {
    EXPECT_EQ(f.left, "");
    // An opening of 1 m, less the cells within a radius of its jambs.
    EXPECT_NEAR(f.width_m, 1 - 2 * ExploreParams().robot_radius_m, 0.15);
    ASSERT_GE(f.stand, 0);
    EXPECT_LT(std::hypot(planner.grid().centreOf(f.stand).x - f.target.x,
                         planner.grid().centreOf(f.stand).y - f.target.y),
              0.6);
  }
  const auto next = chooseFrontier(frontiers, {});
  ASSERT_TRUE(next);
  EXPECT_GT(frontiers[*next].target.x, 9) << "the nearest is on the right";
}

TEST(Frontiers, UtilityGoesFartherForMore) {
  auto rows = kOpenings;
  rows[2].front() = rows[5].front() = ' ';  // the left opening is twice as wide
  const Planner planner = plannerOf(test::drawnMap(rows, 10), {6, 1.75});
  const auto frontiers = findFrontiers(planner, {}, {});
  ExploreParams params;
  EXPECT_GT(frontiers[*chooseFrontier(frontiers, params)].target.x, 9);
  params.frontier_choice = explore::FrontierChoice::utility;
  params.gain_m_per_m = 20;
  EXPECT_LT(frontiers[*chooseFrontier(frontiers, params)].target.x, 1);
}

TEST(Frontiers, TheOrderIsTheSameEachTime) {
  const auto map = test::drawnMap(kOpenings, 10);
  const auto a = findFrontiers(plannerOf(map, {7, 1.75}), {}, {});
  const auto b = findFrontiers(plannerOf(map, {7, 1.75}), {}, {});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].stand, b[i].stand);
    EXPECT_EQ(a[i].cells, b[i].cells);
  }
}

TEST(Frontiers, NarrowerThanTheRobotIsLeft) {
  auto map = test::drawnMap(kOpenings, 10);
  for (int x = 100; x < 104; ++x)
    for (int y = 54; y < 56; ++y) map.set({x, y}, 0);
  std::size_t narrow = 0;
  for (const Frontier& f : findFrontiers(plannerOf(map, {7, 1.75}), {}, {}))
    narrow += f.left == "narrower than the robot";
  EXPECT_EQ(narrow, 1U) << "0.2 x 0.1 m of the floor";
}

TEST(Frontiers, AnIslandBehindAWallIsUnreachable) {
  auto rows = kOpenings;
  for (auto& row : rows) row[14] = '#';
  const auto frontiers = findFrontiers(plannerOf(test::drawnMap(rows, 10), {3, 1.75}), {}, {});
  ASSERT_EQ(frontiers.size(), 2U);
  int unreachable = 0;
  for (const Frontier& f : frontiers) {
    if (f.left.empty()) continue;
    ++unreachable;
    EXPECT_EQ(f.left, "no route leads there");
    EXPECT_GT(f.target.x, 9);
  }
  EXPECT_EQ(unreachable, 1);
}

TEST(Frontiers, FailedOnesAreLeftWithTheReason) {
  const auto map = test::drawnMap(kOpenings, 10);
  const Planner planner = plannerOf(map, {7, 1.75});
  const auto before = findFrontiers(planner, {}, {});
  const Frontier& nearest = before[*chooseFrontier(before, {})];
  std::vector<explore::FailedTarget> failed;
  for (const TPoint2D& c : nearest.cells) failed.push_back({c, "seen from there, nothing new"});
  const auto after = findFrontiers(planner, {}, failed);
  const auto next = chooseFrontier(after, {});
  ASSERT_TRUE(next);
  EXPECT_LT(after[*next].target.x, 1) << "the other one is next";
  EXPECT_EQ(
      std::count_if(after.begin(), after.end(),
                    [](const Frontier& f) { return f.left == "seen from there, nothing new"; }),
      1);
}

TEST(Frontiers, AClosedRoomHasNone) {
  auto rows = kOpenings;
  for (auto& row : rows) row.front() = row.back() = '#';
  const auto frontiers = findFrontiers(plannerOf(test::drawnMap(rows, 10), {3, 1.75}), {}, {});
  EXPECT_TRUE(frontiers.empty());
  EXPECT_FALSE(chooseFrontier(frontiers, {}));
}
