#include <gtest/gtest.h>

#include "../io/temporary_folder.h"
#include "ariadne/core/error.h"
#include "ariadne/sim/world.h"
#include "expect_error.h"

using ariadne::core::Error;
using ariadne::sim::parseWorld;
using ariadne::sim::World;
using ariadne::test::expectError;

namespace {

bool isFree(const World& world, double x, double y) {
  return world.map.getPos(static_cast<float>(x), static_cast<float>(y)) > 0.5F;
}

void expectWorldError(const std::string& text, const std::vector<std::string>& parts) {
  expectError<Error>([&] { parseWorld(text, "w"); }, parts);
}

}  // namespace

TEST(World, CorridorsRoomsAndWalls) {
  const World world = parseWorld(
      "# a corner, a room, a pillar\r\n"
      "corridor 2 0 0 10 0 10 5  # along and up\n"
      "room 3 1 5 4\n"
      "wall 6 -0.5 6.5 0\n"
      "start 1 0.5 90\n",
      "w");
  EXPECT_TRUE(isFree(world, 0.02, 0.98));
  EXPECT_TRUE(isFree(world, -0.98, 0)) << "an end stands half a width beyond its point";
  EXPECT_FALSE(isFree(world, -1.02, 0));
  EXPECT_TRUE(isFree(world, 10.98, -0.98)) << "corners are square";
  EXPECT_TRUE(isFree(world, 10.98, 5.98));
  EXPECT_FALSE(isFree(world, 8, 2));
  EXPECT_TRUE(isFree(world, 4, 3.98));
  EXPECT_FALSE(isFree(world, 4, 4.02));
  EXPECT_FALSE(isFree(world, 6.25, -0.25));
  EXPECT_TRUE(isFree(world, 6.25, 0.25));
  EXPECT_DOUBLE_EQ(world.start->x, 1);
  EXPECT_DOUBLE_EQ(world.start->phi, M_PI / 2);
  EXPECT_NEAR(world.map.getResolution(), 0.05, 1e-6);
  EXPECT_NEAR(world.map.getXMin(), -2, 1e-4);
  EXPECT_NEAR(world.map.getYMax(), 7, 1e-4);
}

TEST(World, CorridorsAtAnyAngle) {
  const World world = parseWorld("resolution_m 0.02\ncorridor 1 0 0 3 4\nstart 0 0 0", "w");
  // Along (0.6, 0.8), across (0.8, -0.6).
  EXPECT_TRUE(isFree(world, 1.5 + 0.48 * 0.8, 2 - 0.48 * 0.6));
  EXPECT_FALSE(isFree(world, 1.5 + 0.52 * 0.8, 2 - 0.52 * 0.6));
  EXPECT_TRUE(isFree(world, 5.48 * 0.6, 5.48 * 0.8));
  EXPECT_FALSE(isFree(world, 5.52 * 0.6, 5.52 * 0.8));
}

TEST(World, ALaterCommandPaintsOverAnEarlierOne) {
  const World world =
      parseWorld("room 0 0 4 4\nwall 1 1 3 3\nroom 1.5 1.5 2 2\nstart 0.5 0.5 0", "w");
  EXPECT_FALSE(isFree(world, 2.5, 2.5));
  EXPECT_TRUE(isFree(world, 1.75, 1.75));
}

TEST(World, ErrorsSayWhereAndWhatWouldBeRight) {
  const std::string good = "room 0 0 4 4\nstart 1 1 0\n";
  expectWorldError(good + "coridor 2 0 0 1 1", {"w:3", "coridor", "nearest is \"corridor\""});
  expectWorldError(good + "corridor 2 0 0 5", {"w:3", "an odd count of coordinates, 3", "x y x y"});
  expectWorldError(good + "corridor 2 0 0", {"w:3", "two points at least"});
  expectWorldError(good + "corridor 0 0 0 1 1", {"w:3", "the width", "0.1 to 100"});
  expectWorldError(good + "room 1 2 3", {"w:3", "3 words", "room x0 y0 x1 y1"});
  expectWorldError(good + "wall 1 2 1 3", {"w:3", "no area"});
  expectWorldError(good + "room 1 2 3 nan", {"w:3", "coordinate 4", "nan"});
  expectWorldError(good + "room 1 2 3 1e300", {"w:3", "coordinate 4", "-100000 to 100000"});
  expectWorldError(good + "room 1 2 3 4x", {"w:3", "4x", "a number"});
  expectWorldError(good + "start 1 1 0", {"w:3", "a second one"});
  expectWorldError(good + "resolution_m 0.001", {"w:3", "0.01 to 0.5"});
  expectWorldError(good + "resolution_m", {"w:3", "0 words"});
  expectWorldError(good + "resolution_m 0.1\nresolution_m 0.1", {"w:4", "a second one"});
  expectWorldError(good + std::string(1, '\0'), {"w: a NUL byte"});
}

TEST(World, ErrorsOfTheWhole) {
  expectWorldError("", {"w: nothing is carved"});
  expectWorldError("wall 0 0 1 1\nstart 0.5 0.5 0", {"nothing is carved"});
  expectWorldError("room 0 0 4 4", {"w: ", "start x y deg"});
  expectWorldError("start 5 5 0\nroom 0 0 4 4", {"w:1", "in rock"});
  expectWorldError("start 50 5 0\nroom 0 0 4 4", {"w:1", "in rock"});
  expectWorldError("start 1 1 0\nroom 0 0 4 501", {"4 x 501 m", "500 x 500 m at most"});
  expectWorldError("start 1 1 0\nresolution_m 0.01\nroom 0 0 400 400", {"cells", "resolution_m"});
}

class WorldFile : public TemporaryFolder {};

TEST_F(WorldFile, ThatCannotBeRead) {
  const auto read = [&](const char* name) {
    return [this, name] { ariadne::sim::readWorld(folder / name); };
  };
  expectError<Error>(read("missing.world"), {"cannot read", "missing.world", "No such file"});
  expectError<Error>(read("."), {"it is a folder"});
}
