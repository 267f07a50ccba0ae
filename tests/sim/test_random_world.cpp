#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ariadne/sim/random_world.h"
#include "ariadne/sim/world.h"

using namespace ariadne;
using sim::RandomWorld;

namespace {

sim::World drawn(RandomWorld kind, std::uint64_t seed) {
  return sim::parseWorld("resolution_m 0.1\n" + sim::randomWorld(kind, seed), "drawn");
}

/// Cells whose disc of `radius` cells is free of what a robot touches.
std::vector<bool> standable(const mrpt::maps::COccupancyGridMap2D& bodies, int radius) {
  const int w = static_cast<int>(bodies.getSizeX()), h = static_cast<int>(bodies.getSizeY());
  std::vector<bool> free(static_cast<std::size_t>(w * h), true);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      if (bodies.getCell(x, y) > 0.5F) continue;
      for (int j = std::max(0, y - radius); j <= std::min(h - 1, y + radius); ++j)
        for (int i = std::max(0, x - radius); i <= std::min(w - 1, x + radius); ++i)
          if ((i - x) * (i - x) + (j - y) * (j - y) <= radius * radius)
            free[static_cast<std::size_t>(j * w + i)] = false;
    }
  return free;
}

/// Share of where a robot of 0.3 m radius could stand that it reaches from the start.
double reached(const sim::World& world) {
  const int w = static_cast<int>(world.bodies.getSizeX());
  const std::vector<bool> free = standable(world.bodies, 3);
  std::vector<bool> seen(free.size(), false);
  std::vector<int> next{world.bodies.y2idx(world.start->y) * w +
                        world.bodies.x2idx(world.start->x)};
  double standing = 0, there = 0;
  while (!next.empty()) {
    const auto at = static_cast<std::size_t>(next.back());
    const int here = next.back();
    next.pop_back();
    if (!free[at] || seen[at]) continue;
    seen[at] = true;
    ++there;
    for (const int by : {1, -1, w, -w}) next.push_back(here + by);
  }
  for (const bool f : free) standing += f;
  return there / standing;
}

}  // namespace

TEST(RandomWorld, ARobotReachesItsRooms) {
  for (const RandomWorld kind : {RandomWorld::office, RandomWorld::corridors})
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      EXPECT_GT(reached(drawn(kind, seed)), 0.99) << seed;
}

TEST(RandomWorld, TheSeedAloneDecides) {
  for (const RandomWorld kind : {RandomWorld::office, RandomWorld::corridors}) {
    EXPECT_EQ(sim::randomWorld(kind, 7), sim::randomWorld(kind, 7));
    EXPECT_NE(sim::randomWorld(kind, 7), sim::randomWorld(kind, 8));
  }
}

TEST(RandomWorld, OfficesHaveRoomsFurnitureAndGlassAndCorridorsDoNot) {
  std::string offices;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    offices += sim::randomWorld(RandomWorld::office, seed);
  for (const char* what : {"\nroom", "\nwall", "\nglass", "\ncorridor"})
    EXPECT_NE(offices.find(what), std::string::npos) << what;
  EXPECT_EQ(sim::randomWorld(RandomWorld::corridors, 3).find("\nroom"), std::string::npos);
}
