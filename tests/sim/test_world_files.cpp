// Worlds that other programs made.
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>

#include <cstring>

#include "../io/temporary_folder.h"
#include "ariadne/io/map_files.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/sim/robot.h"
#include "ariadne/sim/world.h"
#include "expect_error.h"

using namespace ariadne;
using sim::readWorld;
using sim::World;
using test::expectError;

namespace {

class WorldFiles : public TemporaryFolder {
 protected:
  const World drawn =
      sim::parseWorld("corridor 2  0 0  6 0\nroom 4 1 6 3\nstart 1 0 0", "drawn.world");

  void expectSameFloor(const World& world) const {
    for (double x = -1.95; x < 8; x += 0.1)
      for (double y = -1.95; y < 4; y += 0.1) {
        const auto at = [&](const World& w) {
          return w.map.getPos(static_cast<float>(x), static_cast<float>(y)) > 0.5F;
        };
        EXPECT_EQ(at(world), at(drawn)) << x << ", " << y;
      }
    EXPECT_FALSE(world.start);
  }
};

}  // namespace

TEST_F(WorldFiles, RosMapsAndGridmapsAreTheSameWorld) {
  io::writeRosMap(folder / "map.pgm", drawn.map);
  io::writeGridmap(folder / "map.gridmap.gz", drawn.map);
  expectSameFloor(readWorld(folder / "map.yaml"));
  expectSameFloor(readWorld(folder / "map.gridmap.gz"));
}

TEST_F(WorldFiles, WhatAMapDoesNotKnowIsRock) {
  mrpt::maps::COccupancyGridMap2D map(0, 2, 0, 1, 0.1F);
  map.fill(0.5F);
  map.setCell(3, 3, 0.95F);
  io::writeGridmap(folder / "map.gridmap.gz", map);
  const World world = readWorld(folder / "map.gridmap.gz");
  EXPECT_LT(world.map.getCell(10, 5), 0.1F);
  EXPECT_GT(world.map.getCell(3, 3), 0.9F);
  EXPECT_LT(world.bodies.getCell(10, 5), 0.1F);
}

TEST_F(WorldFiles, APictureNeedsItsResolution) {
  io::writeMapPng(folder / "map.png", drawn.map);
  expectError<core::Error>([&] { readWorld(folder / "map.png"); },
                           {"map.png", "does not say how large its pixels are"});
  const World world = sim::readWorldPicture(folder / "map.png", 0.05);
  EXPECT_EQ(world.map.getSizeX(), drawn.map.getSizeX());
  EXPECT_EQ(world.map.getSizeY(), drawn.map.getSizeY());
  int differ = 0;
  for (unsigned y = 0; y < world.map.getSizeY(); ++y)
    for (unsigned x = 0; x < world.map.getSizeX(); ++x)
      differ += (world.map.getCell(static_cast<int>(x), static_cast<int>(y)) > 0.5F) !=
                (drawn.map.getCell(static_cast<int>(x), static_cast<int>(y)) > 0.5F);
  EXPECT_EQ(differ, 0);
  expectError<core::UsageError>([&] { sim::readWorldPicture(folder / "map.png", 7); },
                                {"7", "0.01 to 0.5"});
}

TEST_F(WorldFiles, BadFilesAreNamed) {
  for (const char* name : {"a.yaml", "a.gridmap.gz", "a.gridmap"}) {
    expectError<core::Error>([&] { readWorld(folder / name); }, {name, "No such file"});
    io::writeWhole(folder / name, "certainly: [no map");
    expectError<core::Error>(
        [&] { readWorld(folder / name); },
        {name, name == std::string("a.yaml") ? "this is no YAML" : "cannot be read as an MRPT"});
  }
  mrpt::maps::COccupancyGridMap2D unknown(0, 1, 0, 1, 0.1F);
  unknown.fill(0.5F);
  io::writeGridmap(folder / "u.gridmap.gz", unknown);
  expectError<core::Error>([&] { readWorld(folder / "u.gridmap.gz"); }, {"no free cell"});
}

TEST_F(WorldFiles, AFileOfFewBytesDoesNotTakeMuchMemory) {
  io::writeGridmap(folder / "good.gridmap.gz", drawn.map);
  std::string bytes(1 << 20, '\0');
  mrpt::io::CFileGZInputStream unpacked((folder / "good.gridmap.gz").string());
  bytes.resize(unpacked.Read(bytes.data(), bytes.size()));
  // Behind the class's name, version and bits of a cell: cells in x and y, then sides and
  // resolution.
  const std::size_t at = 3 + (static_cast<unsigned char>(bytes[0]) & 0x7fU);
  const auto claim = [&](std::uint32_t cells) {
    const float sides[5] = {0, 0.05F * static_cast<float>(cells), 0,
                            0.05F * static_cast<float>(cells), 0.05F};
    for (const std::size_t offset : {0, 4}) std::memcpy(&bytes[at + offset], &cells, 4);
    std::memcpy(&bytes[at + 8], sides, sizeof(sides));
    io::writeWhole(folder / "bad.gridmap", bytes);
  };
  claim(65536);  // no cell at all, in 32 bits
  expectError<core::Error>([&] { readWorld(folder / "bad.gridmap"); },
                           {"bad.gridmap", "claims 65536 x 65536 cells"});
  claim(9000);
  expectError<core::Error>([&] { readWorld(folder / "bad.gridmap"); }, {"ends early"});
  std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x20\0\0\0\x20\0\x08\0\0\0\0", 29);
  io::writeWhole(folder / "bad.png", png);
  expectError<core::Error>([&] { sim::readWorldPicture(folder / "bad.png", 0.05); },
                           {"bad.png", "8192 x 8192 pixels in 29 bytes"});
  io::writeWhole(folder / "bad.pgm", std::string_view("P5\n# c\n70000 70000\n255\n"));
  expectError<core::Error>([&] { sim::readWorldPicture(folder / "bad.pgm", 0.05); },
                           {"bad.pgm", "claims 70000 x 70000 pixels"});
}

TEST_F(WorldFiles, StartsAreDrawnOnFreeFloor) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto start = sim::drawStart(drawn, 0.2, seed);
    EXPECT_EQ(start, sim::drawStart(drawn, 0.2, seed));
    EXPECT_NO_THROW(sim::Robot(drawn, start, {})) << start.asString();
  }
  EXPECT_NE(sim::drawStart(drawn, 0.2, 1), sim::drawStart(drawn, 0.2, 2));
  expectError<core::Error>([&] { sim::drawStart(drawn, 1.5, 1); }, {"drawn.world", "1.5 m"});
}

TEST_F(WorldFiles, StartsAreDrawnWhereTheRobotCanGoFarthest) {
  // The larger room has less floor than the two others together.
  const World rooms =
      sim::parseWorld("room 0 0 5 5\nroom 6 0 12 5\nroom 13 0 18 5\nstart 1 1 0", "rooms.world");
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const auto start = sim::drawStart(rooms, 0.2, seed);
    EXPECT_GT(start.x, 6) << seed;
    EXPECT_LT(start.x, 12) << seed;
  }
}

TEST(Glass, StopsTheRobotButNotItsLaser) {
  const World world =
      sim::parseWorld("corridor 2  0 0  6 0\nglass 3 -1 3.1 1\nstart 1 0 0", "glass.world");
  sim::DriveParams params;
  params.max_range_m = 30;
  sim::Robot robot(world, *world.start, params);
  const auto scan = robot.scan();
  EXPECT_GT(scan->getScanRange(scan->getScanSize() / 2), 5.5) << "the end of the corridor";
  bool free = true;
  for (int i = 1; i <= 100; ++i) free &= robot.moveUntil(0.1 * i, {0.6, 0});
  EXPECT_FALSE(free);
  EXPECT_LE(robot.pose().x, 3 - 0.2);
  EXPECT_GT(robot.pose().x, 2.5);
}
