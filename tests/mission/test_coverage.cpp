#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/mission/coverage.h"
#include "ariadne/mission/reachable.h"
#include "ariadne/sim/robot.h"
#include "ariadne/sim/senses.h"

using namespace ariadne;

namespace {

/// Two rooms of 6 x 4 m; a door between them where `door` says.
sim::World rooms(const std::string& door) {
  return sim::parseWorld("room 0 0 6 4\nroom 6.5 0 12.5 4\n" + door + "\nstart 1 1 0\n",
                         "rooms.world");
}

sim::DriveParams drive() {
  sim::DriveParams p;
  p.max_range_m = 20;
  return p;
}

bool reaches(const sim::World& world, double x_over) {
  const auto places = mission::reachablePlaces(world, *world.start, 0.2, 0.5);
  return std::any_of(places.begin(), places.end(), [&](const auto& p) { return p.x > x_over; });
}

double shareSeenFrom(const sim::World& world, const std::vector<mrpt::math::TPose2D>& poses) {
  std::vector<models::SensorStep> steps;
  geometry::Trajectory truth;
  sim::Senses senses({0, 0, 0, 0, 0}, 1);
  for (const auto& pose : poses) {
    truth.push_back({static_cast<double>(steps.size()), pose});
    steps.push_back(senses.next(truth.back(), *sim::Robot(world, pose, drive()).scan()));
  }
  return mission::coverage(world, mission::seeable(world, *world.start, drive(), 0.1),
                           mission::sighted(steps, truth, 0.1));
}

}  // namespace

TEST(Reachable, ADoorLetsTheRobotThroughAndAHoleDoesNot) {
  EXPECT_TRUE(reaches(rooms("room 6 1 6.5 2"), 7));
  EXPECT_FALSE(reaches(rooms("room 6 1 6.5 1.3"), 6));
  EXPECT_FALSE(reaches(rooms(""), 6));
}

TEST(Reachable, GlassStopsTheRobot) {
  EXPECT_FALSE(reaches(rooms("room 6 1 6.5 2\nglass 6.2 0 6.3 4"), 6.3));
}

TEST(Reachable, PlacesAreClearOfWallsAndOneASquare) {
  const auto world = rooms("");
  const auto places = mission::reachablePlaces(world, *world.start, 0.2, 0.5);
  EXPECT_EQ(places.front().x, 1);
  for (const auto& p : places) {
    EXPECT_GE(std::min({p.x, p.y, 6 - p.x, 4 - p.y}), 0.2 - 1e-9);
  }
  // 5.6 x 3.6 m in squares of 0.5 m, more or less one at each side.
  EXPECT_GE(places.size(), 11U * 7U);
  EXPECT_LE(places.size(), 13U * 9U);
}

TEST(Reachable, AStartInRockIsAnError) {
  EXPECT_THROW(mission::reachablePlaces(rooms(""), {6.2, 2, 0}, 0.2, 0.5), core::Error);
}

// What ends at a wall straight ahead leaves the last cell before it unknown: two columns of sixty.
TEST(Coverage, ALookFromBothEndsSeesARoom) {
  const auto world = rooms("");
  EXPECT_NEAR(shareSeenFrom(world, {{0.5, 2, 0}, {5.5, 2, M_PI}}), 58.0 / 60, 0.01);
}

TEST(Coverage, OneOfTwoRoomsIsHalf) {
  const auto world = rooms("room 6 1 6.5 2");
  // What the door shows of the other room is seen too.
  const double share = shareSeenFrom(world, {{0.5, 3, 0}, {5.5, 3, M_PI}});
  EXPECT_GT(share, 0.48);
  EXPECT_LT(share, 0.65);
}

TEST(Coverage, ThroughGlassThereIsMoreToSee) {
  const auto glass = rooms("room 6 0 6.5 4\nglass 6.2 0 6.3 4");
  const auto rock = rooms("");
  const std::vector<mrpt::math::TPose2D> poses{{0.5, 2, 0}, {5.5, 2, M_PI}};
  EXPECT_GT(shareSeenFrom(rock, poses), 0.95);
  EXPECT_GT(shareSeenFrom(glass, poses), 0.9);
  EXPECT_LT(shareSeenFrom(rooms("room 6 0 6.5 4\nglass 6.2 0 6.3 4"), {{5.5, 2, M_PI}}), 0.6);
}
