// Shapes of a world and the cells that they cover.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace ariadne::sim {

/// A rectangle at any angle: `half_length` along (cos, sin), `half_width` across. Metres.
struct Block {
  double x = 0, y = 0;
  double cos = 1, sin = 0;
  double half_length = 0, half_width = 0;
  bool rock = false;

  double reachX() const;  ///< half the extent along x
  double reachY() const;
};

Block rectangle(double x0, double y0, double x1, double y1, bool rock);

/// A corridor's pieces, each half a width longer at both ends, so that they join squarely.
std::vector<Block> corridorBlocks(double width_m, const std::vector<mrpt::math::TPoint2D>& line);

constexpr double kMostCells = 1e8;  // of a world

constexpr float kFree = 0.98F;
constexpr float kRock = 0.02F;

/// Sets the cells whose centres lie in the block.
void paint(mrpt::maps::COccupancyGridMap2D& map, const Block& block);

}  // namespace ariadne::sim
