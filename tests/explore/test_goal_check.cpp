// The cheap look at a goal and the way there.
#include <gtest/gtest.h>

#include "ariadne/explore/goal_check.h"

using namespace ariadne;
using explore::ExploreParams;
using explore::Route;

namespace {

/// Free from (0, 0) to (10, 2) m, in cells of 0.1 m; unknown elsewhere.
grid::OccupancyGrid corridor() {
  grid::GridParams params;
  params.resolution_m = 0.1;
  grid::OccupancyGrid map(params);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 100; ++x) map.set({x, y}, 40);
  return map;
}

Route along() {
  Route route;
  for (int i = 5; i < 95; ++i) route.emplace_back(0.1 * i, 1);
  return route;
}

}  // namespace

TEST(RouteHolds, WhileNothingStandsInIt) {
  auto map = corridor();
  EXPECT_TRUE(explore::routeHolds(map, along(), 0, {0.5, 1, 0}, {}));
  map.set({30, 12}, -40);  // 0.25 m beside the middle line: past the robot's 0.2 m
  EXPECT_TRUE(explore::routeHolds(map, along(), 0, {0.5, 1, 0}, {}));
  map.set({30, 11}, -40);
  EXPECT_FALSE(explore::routeHolds(map, along(), 0, {0.5, 1, 0}, {}));
  EXPECT_TRUE(explore::routeHolds(map, along(), 40, {4.5, 1, 0}, {})) << "it is passed";
}

TEST(RouteHolds, WhatIsFarAheadIsNotLookedAt) {
  auto map = corridor();
  map.set({85, 10}, -40);
  EXPECT_TRUE(explore::routeHolds(map, along(), 0, {0.5, 1, 0}, {}));
  EXPECT_FALSE(explore::routeHolds(map, along(), 30, {3.5, 1, 0}, {}));
}

TEST(RouteHolds, OnlyForARobotThatIsOnIt) {
  EXPECT_FALSE(explore::routeHolds(corridor(), along(), 0, {0.5, 1.9, 0}, {}));
  EXPECT_FALSE(explore::routeHolds(corridor(), {}, 0, {0.5, 1, 0}, {}));
}

TEST(BordersUnknown, AFewCellsAreEnoughAndOneIsNot) {
  auto map = corridor();
  EXPECT_FALSE(explore::bordersUnknown(map, {5, 1}, 0.15));
  map.set({50, 10}, 0);
  EXPECT_FALSE(explore::bordersUnknown(map, {5, 1}, 0.15));
  for (int y = 9; y < 11; ++y) map.set({49, y}, 0);
  EXPECT_TRUE(explore::bordersUnknown(map, {5, 1}, 0.15));
}
