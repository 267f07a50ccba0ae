// Worlds to simulate robots in, drawn by a small text file, one command a line, `#` comments:
//
//   resolution_m 0.05             side of a cell; this is the default
//   corridor WIDTH x y x y ...    carves a corridor along a polyline, square at corners and ends
//                                 (it goes on for WIDTH / 2 beyond the first and the last point)
//   room x0 y0 x1 y1              carves a rectangle
//   wall x0 y0 x1 y1              puts rock back into a rectangle
//   start x y deg                 where the robot starts and looks
//
// Lengths are metres. What is not carved is rock. A command paints over those above it. The grid
// reaches 1 m beyond all that is carved.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPose2D.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace ariadne::sim {

struct World {
  std::string name;                     ///< what errors call it: the file
  mrpt::maps::COccupancyGridMap2D map;  ///< probability of being free: 0.98 floor, 0.02 rock
  mrpt::math::TPose2D start;            ///< m, rad, frame of the map
};

/// Throws core::Error naming file and line and saying what would be right: an unknown command,
/// words that are too few, too many or no numbers, nothing carved, no start or one in rock, a world
/// of more than 500 x 500 m or 1e8 cells.
World parseWorld(std::string_view text, const std::string& name);

/// The same for a file; also throws when it cannot be read.
World readWorld(const std::filesystem::path& path);

}  // namespace ariadne::sim
