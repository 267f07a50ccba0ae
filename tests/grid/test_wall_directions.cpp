#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/grid/insertion/wall_directions.h"

using namespace ariadne;
using mrpt::math::TPoint2D;

namespace {

/// What a laser of 10 m with 181 beams over 180 degrees sees of a box about it: walls at y = -1 and
/// y = 1.2, one ahead at `end_m`, 1 cm of noise; the robot is turned to the left by `turned` rad.
grid::WallDirections inBox(double end_m, double turned = 0) {
  core::RandomStream rng(1, 0, 0, core::Purpose::test);
  std::vector<TPoint2D> ends;
  std::vector<std::size_t> beams;
  for (std::size_t i = 0; i < 181; ++i) {
    const double in_robot = -M_PI / 2 + static_cast<double>(i) * M_PI / 180;
    const double a = in_robot + turned;
    const double side_m = std::sin(a) > 0 ? 1.2 : 1.0;
    const double to_side_m = side_m / std::max(1e-9, std::abs(std::sin(a)));
    const double to_end_m = std::cos(a) > 0 ? end_m / std::cos(a) : 1e9;
    const double range_m = std::min(to_side_m, to_end_m) + 0.01 * rng.gaussian();
    if (range_m >= 10) continue;
    ends.emplace_back(range_m * std::cos(in_robot), range_m * std::sin(in_robot));
    beams.push_back(i);
  }
  return grid::wallDirections(ends, beams);
}

}  // namespace

TEST(WallDirections, ABareCorridorTellsNothingAlongIt) {
  for (const double turned : {0.0, 0.4, -1.2}) {
    const auto walls = inBox(100, turned);
    EXPECT_LT(walls.across, 0.005) << turned;
    EXPECT_GT(std::abs(walls.axis.x * std::cos(turned) - walls.axis.y * std::sin(turned)), 0.999)
        << turned;
  }
}

TEST(WallDirections, TheEndOfACorridorTells) { EXPECT_GT(inBox(7).across, 0.02); }

TEST(WallDirections, ARoomTellsOfAll) { EXPECT_GT(inBox(1.1).across, 0.2); }

TEST(WallDirections, ClutterTellsOfAll) {
  core::RandomStream rng(1, 0, 0, core::Purpose::test);
  std::vector<TPoint2D> ends;
  std::vector<std::size_t> beams;
  for (std::size_t i = 0; i < 100; ++i) {
    ends.emplace_back(3 + 0.05 * rng.gaussian(), 0.02 * static_cast<double>(i));
    beams.push_back(i);
  }
  EXPECT_GT(grid::wallDirections(ends, beams).across, 0.4);
}

TEST(WallDirections, FewEndsTellNothingOfWalls) {
  EXPECT_EQ(grid::wallDirections({}, {}).across, 0.5);
  EXPECT_EQ(grid::wallDirections({{1, 0}, {1, 0.1}, {1, 0.2}}, {0, 1, 2}).across, 0.5);
}
