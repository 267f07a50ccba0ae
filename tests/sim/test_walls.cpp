#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ariadne/sim/walls.h"

using namespace ariadne;

namespace {

/// A room of 6 x 4 m with a pillar of half a metre in it.
sim::World pillarRoom() {
  return sim::parseWorld("room 0 0 6 4\nwall 3 1.75 3.5 2.25\nstart 1 2 0\n", "pillar.world");
}

sim::DriveParams laser(double range_m) {
  sim::DriveParams p;
  p.max_range_m = range_m;
  p.beams = 721;
  return p;
}

bool anyNear(const std::vector<mrpt::math::TPoint2D>& walls, double x, double y) {
  return std::any_of(walls.begin(), walls.end(),
                     [&](const auto& w) { return std::hypot(w.x - x, w.y - y) < 0.1; });
}

}  // namespace

TEST(WallsHit, AreThoseThatARobotSees) {
  const auto world = pillarRoom();
  const auto walls = sim::wallsHit(world, {{0, {1, 2, 0}}}, laser(20));
  EXPECT_TRUE(anyNear(walls, 3, 2)) << "the face of the pillar";
  EXPECT_FALSE(anyNear(walls, 3.5, 2)) << "its back";
  EXPECT_TRUE(anyNear(walls, 6, 0.6)) << "the wall beside it";
  EXPECT_FALSE(anyNear(walls, 6, 2)) << "what it hides";
  EXPECT_FALSE(anyNear(walls, 0, 2)) << "what is behind the robot";
  for (const auto& w : walls)
    EXPECT_LT(world.map.getPos(static_cast<float>(w.x), static_cast<float>(w.y)), 0.5F)
        << w.x << ", " << w.y << " is no rock";
}

TEST(WallsHit, EndWhereTheLaserDoes) {
  const auto walls = sim::wallsHit(pillarRoom(), {{0, {1, 2, 0}}}, laser(4));
  EXPECT_TRUE(anyNear(walls, 3, 2));
  EXPECT_FALSE(anyNear(walls, 6, 0.6));
}

TEST(WallsHit, NoPassingBeamTakesAWallAway) {
  const auto world = pillarRoom();
  // Along the lower wall, at 5 cm: nearly all of its beams graze it.
  geometry::Trajectory along;
  for (int i = 0; i < 200; ++i) along.push_back({0.1 * i, {0.3 + 0.025 * i, 0.05, 0}});
  const auto once = sim::wallsHit(world, {along.begin(), along.begin() + 1}, laser(20));
  const auto all = sim::wallsHit(world, along, laser(20));
  for (const auto& w : once)
    EXPECT_NE(std::find(all.begin(), all.end(), w), all.end()) << w.x << ", " << w.y;
}

TEST(KeyMoments, AreWhereTheRobotMovedOrTurned) {
  const geometry::Trajectory path = {{0, {0, 0, 0}},   {1, {0.1, 0, 0}},   {2, {0.2, 0, 0}},
                                     {3, {0.2, 0, 1}}, {4, {0.2, 0, 1.1}}, {5, {0.2, 0.5, 1.1}}};
  EXPECT_EQ(sim::keyMoments(path), (std::vector<std::size_t>{0, 2, 3, 5}));
  EXPECT_TRUE(sim::keyMoments({}).empty());
}
