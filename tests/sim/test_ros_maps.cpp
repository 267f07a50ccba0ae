// Maps of ROS map_server and nav2 as worlds.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <algorithm>
#include <cmath>

#include "../io/png_bytes.h"
#include "../io/temporary_folder.h"
#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/sim/world.h"
#include "expect_error.h"

using namespace ariadne;
using sim::World;
using test::expectError;

namespace {

using Rows = std::vector<std::string>;  // the northernmost first; '#' 0, '.' 254, '?' 205

class RosMaps : public TemporaryFolder {
 protected:
  World world(const std::string& yaml) const {
    io::writeWhole(folder / "m.yaml", yaml);
    return sim::readWorld(folder / "m.yaml");
  }
  static std::string keys(const std::string& resolution, const std::string& origin,
                          const std::string& thresholds = "free_thresh: 0.196") {
    return "image: m.pgm\nresolution: " + resolution + "\norigin: " + origin +
           "\nnegate: 0\noccupied_thresh: 0.65\n" + thresholds + "\n";
  }
  void writePgm(const Rows& rows) const {
    std::string pgm =
        "P5\n" + std::to_string(rows[0].size()) + " " + std::to_string(rows.size()) + "\n255\n";
    for (const std::string& row : rows)
      for (const char c : row) pgm += static_cast<char>(c == '#' ? 0 : c == '.' ? 254 : 205);
    io::writeWhole(folder / "m.pgm", pgm);
  }
  /// One row of these gray levels.
  void writeShades(const std::vector<std::uint8_t>& shades) const {
    io::writeWhole(folder / "m.pgm", "P5\n" + std::to_string(shades.size()) + " 1\n255\n" +
                                         std::string(shades.begin(), shades.end()));
  }
};

bool isFloor(const World& world, int x, int y) { return world.map.getCell(x, y) > 0.5F; }

/// The world's cells as rows.
Rows rowsOf(const World& world) {
  Rows rows;
  for (int y = static_cast<int>(world.map.getSizeY()); y-- > 0;) {
    rows.emplace_back();
    for (int x = 0; x < static_cast<int>(world.map.getSizeX()); ++x)
      rows.back() += isFloor(world, x, y) ? '.' : '#';
  }
  return rows;
}

/// A room of `side` cells whose walls are a cell thick, with some thin ones in it: straight, and
/// oblique ones that hang together by corners alone.
Rows roomWithWalls(int side, core::RandomStream& random) {
  Rows rows(static_cast<std::size_t>(side),
            "#" + std::string(static_cast<std::size_t>(side) - 2, '.') + "#");
  rows.front() = rows.back() = std::string(static_cast<std::size_t>(side), '#');
  const auto some = [&](int below) { return static_cast<int>(random.uniform() * below); };
  for (int wall = 0; wall < 4; ++wall) {
    int x = some(side), y = some(side);
    const int step_x = some(3) - 1, step_y = some(3) - 1;
    for (int i = 0; i < side / 2; ++i, x += step_x, y += step_y)
      if (x >= 0 && y >= 0 && x < side && y < side)
        rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '#';
  }
  return rows;
}

/// How far from (x, y), in cells of the plan, it is to rock; exact, by the sides that a ray
/// crosses.
double distanceToRock(const Rows& rows, double x, double y, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto height = static_cast<int>(rows.size());
  double at = 0;
  for (int crossed = 0; crossed < 10 * height; ++crossed) {
    const double px = x + c * (at + 1e-9), py = y + s * (at + 1e-9);
    const int ix = static_cast<int>(std::floor(px)), iy = static_cast<int>(std::floor(py));
    if (rows[static_cast<std::size_t>(height - 1 - iy)][static_cast<std::size_t>(ix)] != '.')
      return at;
    const double to_x = c > 0 ? (ix + 1 - px) / c : c < 0 ? (ix - px) / c : 1e9;
    const double to_y = s > 0 ? (iy + 1 - py) / s : s < 0 ? (iy - py) / s : 1e9;
    at += std::min(to_x, to_y) + 1e-9;
  }
  return at;
}

}  // namespace

TEST_F(RosMaps, EveryKeyCounts) {
  // The upper row is the northern one.
  io::writeWhole(folder / "m.pgm", std::string_view("P5\n4 2\n255\n\0\x64\xc8\xff\0\0\0\0", 19));
  const auto floor = [&](const std::string& more) {
    const World w = world("image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\n" + more);
    EXPECT_FLOAT_EQ(w.map.getXMin(), -1);
    EXPECT_FLOAT_EQ(w.map.getYMin(), 2);
    EXPECT_TRUE(w.notes.empty());
    EXPECT_FALSE(w.start);
    return rowsOf(w)[0];
  };
  EXPECT_EQ(floor("negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"), "###.");
  EXPECT_EQ(floor("negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"), "##..");
  EXPECT_EQ(floor("negate: 0\noccupied_thresh: 0.1\nfree_thresh: 0.1\n"), "###.");
  EXPECT_EQ(floor("negate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.5\nmode: trinary\n"), "..##");
  EXPECT_EQ(floor("negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\nmode: scale\n"), "##..");
  // Percent, 0 to 100; what is over 100 is unknown.
  EXPECT_EQ(floor("negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\nmode: raw\n"), ".###");
}

TEST_F(RosMaps, EveryStyleIsTheSameWorld) {
  writePgm({"####", "#..#", "#.?#", "####"});
  const Rows right = {"####", "#..#", "#.##", "####"};
  const std::string block = keys("0.5", "\n- -1\n- 2\n- 0");
  std::string crlf = "\xef\xbb\xbf";
  for (const char c : keys("0.5", "[-1, 2, 0]"))
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (const std::string& yaml :
       {block, crlf,
        std::string("{image: m.pgm, resolution: 0.5, origin: [-1, 2, 0], negate: 0, "
                    "occupied_thresh: 0.65, free_thresh: 0.196}\n")}) {
    EXPECT_EQ(rowsOf(world(yaml)), right) << yaml;
    EXPECT_FLOAT_EQ(sim::readWorld(folder / "m.yaml").map.getXMin(), -1);
  }
}

TEST_F(RosMaps, WhatTheSaversWriteForUnknownIsRock) {
  writePgm({"####??", "#..#??", "####??"});
  const Rows right = {"######", "#..###", "######"};
  const World by_default = world(keys("0.05", "[0, 0, 0]", "free_thresh: 0.196"));
  EXPECT_EQ(rowsOf(by_default), right);
  EXPECT_TRUE(by_default.notes.empty());
  const World of_nav2 = world(keys("0.05", "[0, 0, 0]", "mode: trinary\nfree_thresh: 0.25"));
  EXPECT_EQ(rowsOf(of_nav2), right);
  ASSERT_EQ(of_nav2.notes.size(), 1U);
  EXPECT_NE(of_nav2.notes[0].find("m.yaml: free_thresh 0.25 would make floor of gray 205"),
            std::string::npos)
      << of_nav2.notes[0];
  // Inverted it is 50.
  writeShades({255, 50, 50, 1, 1});
  const std::string inverted =
      "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 1\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.25\n";
  EXPECT_EQ(rowsOf(world(inverted)), Rows{"###.."});
}

TEST_F(RosMaps, AGrayAmongOthersIsNoCode) {
  std::vector<std::uint8_t> shades;
  for (int s = 190; s < 255; ++s) shades.push_back(static_cast<std::uint8_t>(s));
  shades.push_back(205);
  writeShades(shades);
  const World w = world(keys("0.05", "[0, 0, 0]", "free_thresh: 0.25"));
  EXPECT_TRUE(w.notes.empty());
  EXPECT_TRUE(isFloor(w, 15, 0));  // 205, under 0.25
  EXPECT_FALSE(isFloor(w, 0, 0));  // 190: 0.255
  // In mode scale unknown is transparent, and 205 a probability like any other.
  writeShades({0, 205, 205, 254});
  EXPECT_EQ(rowsOf(world(keys("0.05", "[0, 0, 0]", "mode: scale\nfree_thresh: 0.25"))),
            Rows{"#..."});
}

TEST_F(RosMaps, TransparentPixelsAreRock) {
  using test::pngBytes;
  for (const char* mode : {"trinary", "scale", "raw"}) {
    const std::uint8_t free = mode == std::string("raw") ? 0 : 254;
    const std::string yaml =
        "image: m.png\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.3\nmode: " +
        std::string(mode);
    io::writeWhole(folder / "m.png",
                   pngBytes(3, {PNG_COLOR_TYPE_GRAY_ALPHA}, {{free, 255, free, 0, free, 254}}));
    EXPECT_EQ(rowsOf(world(yaml)), Rows{".##"}) << mode;
    io::writeWhole(folder / "m.png", pngBytes(2, {PNG_COLOR_TYPE_RGB_ALPHA},
                                              {{free, free, free, 0, free, free, free, 255}}));
    EXPECT_EQ(rowsOf(world(yaml)), Rows{"#."}) << mode;
  }
  io::writeWhole(folder / "m.png", pngBytes(2, {PNG_COLOR_TYPE_GRAY_ALPHA}, {{255, 0, 255, 255}}));
  EXPECT_EQ(rowsOf(sim::readWorldPicture(folder / "m.png", 0.1)), Rows{"#."});
}

TEST_F(RosMaps, MrptReadsTheSame) {
  core::RandomStream random(5, 0, 0, core::Purpose::start);
  writePgm(roomWithWalls(40, random));
  const World ours = world(keys("0.05", "[-1, 0.5, 0]"));
  mrpt::maps::COccupancyGridMap2D mrpts;
  ASSERT_TRUE(mrpts.loadFromROSMapServerYAML((folder / "m.yaml").string()));
  ASSERT_EQ(mrpts.getSizeX(), ours.map.getSizeX());
  ASSERT_EQ(mrpts.getSizeY(), ours.map.getSizeY());
  EXPECT_EQ(mrpts.getXMin(), ours.map.getXMin());
  EXPECT_EQ(mrpts.getYMin(), ours.map.getYMin());
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) EXPECT_EQ(mrpts.getCell(x, y) > 0.5F, isFloor(ours, x, y));
}

TEST_F(RosMaps, QuarterTurnsKeepEachCell) {
  writePgm({"#####", "#...#", "#.###", "#####"});
  const auto turned = [&](const char* yaw) {
    return world(keys("0.5", std::string("[1, 2, ") + yaw + "]"));
  };
  const Rows upright = {"#####", "#...#", "#.###", "#####"};
  const World none = turned("1e-3");  // a hundredth of a cell at the far end
  EXPECT_EQ(rowsOf(none), upright);
  // Its lower left corner stays at (1, 2); left of it is what was above.
  for (const char* yaw : {"1.5707963", "1.5708", "-4.712389"}) {
    const World left = turned(yaw);
    EXPECT_EQ(rowsOf(left), (Rows{"####", "#.##", "#.##", "#..#", "####"})) << yaw;
    EXPECT_FLOAT_EQ(left.map.getXMin(), -1);
    EXPECT_FLOAT_EQ(left.map.getYMin(), 2);
    EXPECT_FLOAT_EQ(left.map.getResolution(), 0.5);
  }
  const World back = turned("-3.14159");
  EXPECT_EQ(rowsOf(back), (Rows{"#####", "###.#", "#...#", "#####"}));
  EXPECT_FLOAT_EQ(back.map.getXMin(), -1.5);
  EXPECT_FLOAT_EQ(back.map.getYMin(), 0);
  const World right = turned("-1.5707963");
  EXPECT_EQ(rowsOf(right), (Rows{"####", "#..#", "##.#", "##.#", "####"}));
  EXPECT_FLOAT_EQ(right.map.getXMin(), 1);
  EXPECT_FLOAT_EQ(right.map.getYMin(), -0.5);
}

TEST_F(RosMaps, AnOriginBetweenCellsLosesNone) {
  writePgm({"####", "#..#", "####"});
  for (const char* origin :
       {"[0.025, -0.025, 0]", "[0.0749, 1.1, 0]", "[-3.17, 0.02, 1.5707963]"}) {
    const World w = world(keys("0.05", origin));
    std::size_t floor = 0;
    for (const auto& row : rowsOf(w)) floor += std::count(row.begin(), row.end(), '.');
    EXPECT_EQ(floor, 2U) << origin;
    EXPECT_EQ(w.map.getSizeX() * w.map.getSizeY(), 12U) << origin;
  }
}

/// In a turned world each ray ends where it ends in the plan, and none goes through a wall.
TEST_F(RosMaps, ATurnedWallHasNoHole) {
  constexpr int kSide = 60;
  constexpr double kCell_m = 0.05;
  for (std::uint32_t trial = 0; trial < 20; ++trial) {
    core::RandomStream random(7, trial, 0, core::Purpose::start);
    const double yaw = (2 * random.uniform() - 1) * M_PI;
    const double x0 = 20 * random.uniform() - 10, y0 = 20 * random.uniform() - 10;
    const Rows rows = roomWithWalls(kSide, random);
    writePgm(rows);
    const World w = world(keys("0.05", fmt::format("[{}, {}, {}]", x0, y0, yaw)));
    EXPECT_FLOAT_EQ(w.map.getResolution(), kCell_m / 2);
    int rays = 0;
    for (int i = 0; i < 40; ++i) {
      const double px = 1 + (kSide - 2) * random.uniform(), py = 1 + (kSide - 2) * random.uniform();
      const double wx = x0 + kCell_m * (std::cos(yaw) * px - std::sin(yaw) * py);
      const double wy = y0 + kCell_m * (std::sin(yaw) * px + std::cos(yaw) * py);
      if (w.map.getPos(static_cast<float>(wx), static_cast<float>(wy)) < 0.5F) continue;
      mrpt::obs::CObservation2DRangeScan scan;
      scan.aperture = static_cast<float>(2 * M_PI);
      scan.maxRange = 10;
      w.map.laserScanSimulator(scan, {wx, wy, yaw}, 0.5F, 90);
      for (std::size_t beam = 0; beam < scan.getScanSize(); ++beam) {
        ++rays;
        const double angle = 2 * M_PI * (static_cast<double>(beam) / 89 - 0.5);
        // MRPT's ray goes by steps of 0.8 cells and may miss the very end of a wall; so the ray of
        // the plan that is compared may lie three quarters of a cell to either side.
        double longest = 0;
        for (const double aside : {-0.75, 0.0, 0.75})
          longest =
              std::max(longest, kCell_m * distanceToRock(rows, px - aside * std::sin(angle),
                                                         py + aside * std::cos(angle), angle));
        ASSERT_TRUE(scan.getScanRangeValidity(beam)) << trial << ": out of the room";
        ASSERT_LT(scan.getScanRange(beam), longest + kCell_m) << trial << ": through a wall";
      }
    }
    EXPECT_GT(rays, 500) << trial;
  }
}

TEST_F(RosMaps, ATurnedFloorLosesLittle) {
  constexpr int kSide = 60;
  core::RandomStream random(9, 0, 0, core::Purpose::start);
  const Rows rows = roomWithWalls(kSide, random);
  writePgm(rows);
  const double yaw = 0.7;
  const World w = world(keys("0.05", "[2, 3, 0.7]"));
  const auto source = [&](double x, double y) {
    const double dx = (x - 2) / 0.05, dy = (y - 3) / 0.05;
    const double px = std::cos(yaw) * dx + std::sin(yaw) * dy;
    const double py = std::cos(yaw) * dy - std::sin(yaw) * dx;
    if (px < 0 || py < 0 || px >= kSide || py >= kSide) return false;
    return rows[static_cast<std::size_t>(kSide - 1 - static_cast<int>(py))]
               [static_cast<std::size_t>(px)] == '.';
  };
  int floor = 0, lost = 0;
  for (int y = 0; y < static_cast<int>(w.map.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(w.map.getSizeX()); ++x) {
      const double wx = w.map.idx2x(x), wy = w.map.idx2y(y);
      EXPECT_LE(isFloor(w, x, y), source(wx, wy)) << "rock became floor";
      floor += source(wx, wy);
      lost += source(wx, wy) && !isFloor(w, x, y);
      // Farther than half its diagonal (0.018 m) from rock a cell stays floor.
      bool far = true;
      for (int k = 0; k < 16; ++k)
        far &= source(wx + 0.019 * std::cos(k * M_PI / 8), wy + 0.019 * std::sin(k * M_PI / 8));
      EXPECT_LE(far && source(wx, wy), isFloor(w, x, y)) << wx << ", " << wy;
    }
  EXPECT_GT(lost, 0);
  EXPECT_LT(lost, floor / 8);
}

TEST_F(RosMaps, ErrorsNameTheFile) {
  writePgm({"#.#"});
  const auto refused = [&](const std::string& yaml, const std::vector<std::string>& parts) {
    expectError<core::Error>([&] { world(yaml); }, parts);
  };
  const std::string good = keys("0.05", "[0, 0, 0]");
  refused("resolution: 0.05\n", {"m.yaml", "image is missing, as in image: map.pgm"});
  refused(good.substr(good.find('\n')) + "image: none.pgm\n", {"none.pgm", "No such file"});
  refused(good + "free_thresh: 0.2\n", {"m.yaml:7: free_thresh comes twice"});
  writePgm({"###"});
  refused(good, {"m.yaml", "no free cell"});
}
