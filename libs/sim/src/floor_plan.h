// Cells of floor as a picture has them, and the grid that they become where they lie in the world.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPose2D.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ariadne/io/picture_file.h"

namespace ariadne::sim {

struct FloorPlan {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> floor;  ///< row by row from the lowest; 1 is floor, 0 is rock

  FloorPlan(int columns_, int rows_);
  /// Of a picture's pixels by their shade; what is transparent is rock.
  FloorPlan(const io::PicturePixels& picture, const std::array<bool, 256>& floor_shades);
  std::uint8_t& at(int x, int y);
  bool isFloor(int x, int y) const;  ///< what lies outside is rock
};

/// The plan with its lower left corner at `world_from_plan`, in cells of kFree and kRock.
///
/// Turned by quarters of a circle (to a quarter of a cell at its far end) it keeps its cells.
/// Turned otherwise it is drawn anew in cells of half the side (of the same where those would be
/// over 1e8 or under 0.005 m), and a cell is floor only when all that it covers is: so rock grows
/// by up to 0.71 of a new cell, and no wall gets a hole, however thin it is.
/// @param resolution_m side of the plan's cells
/// Throws core::Error with `name` in it when that would be over 1e8 cells.
mrpt::maps::COccupancyGridMap2D placedGrid(const FloorPlan& plan, double resolution_m,
                                           const mrpt::math::TPose2D& world_from_plan,
                                           const std::string& name);

}  // namespace ariadne::sim
