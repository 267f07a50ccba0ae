// Worlds to simulate robots in, drawn by a small text file, one command a line, `#` comments:
//
//   resolution_m 0.05             side of a cell; this is the default
//   corridor WIDTH x y x y ...    carves a corridor along a polyline, square at corners and ends
//                                 (it goes on for WIDTH / 2 beyond the first and the last point)
//   room x0 y0 x1 y1              carves a rectangle
//   wall x0 y0 x1 y1              puts rock back into a rectangle
//   glass x0 y0 x1 y1             stops the robot but not its laser
//   start x y deg                 where the robot starts and looks
//
// Lengths are metres. What is not carved is rock. A command paints over those above it. The grid
// reaches 1 m beyond all that is carved.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ariadne::sim {

/// A building: walls, marks, where the robot starts.
struct World {
  std::string name;                        ///< what errors call it: the file
  mrpt::maps::COccupancyGridMap2D map;     ///< probability of being free: 0.98 floor, 0.02 rock
  mrpt::maps::COccupancyGridMap2D bodies;  ///< the same with glass as rock: what the robot touches
  /// m, rad, frame of the map; none in a map that names no start
  std::optional<mrpt::math::TPose2D> start;
  /// What its user should be told of how the file was read, each a sentence with the file's name.
  std::vector<std::string> notes;
};

/// Throws core::Error naming file and line and saying what would be right: an unknown command,
/// words that are too few, too many or no numbers, nothing carved, no start or one in rock, a world
/// of more than 500 x 500 m or 1e8 cells.
World parseWorld(std::string_view text, const std::string& name);

/// A world from a file, by the ending of its name: .yaml of ROS map_server or nav2, MRPT's .gridmap
/// or .gridmap.gz, else the text above. What a map does not know is rock. A ROS map lies where its
/// origin says, turned by its yaw: poses are those of ROS's frame `map`, to half a cell. Throws
/// core::Error naming the file and why it cannot be used; a map of no free cell too.
World readWorld(const std::filesystem::path& path);

/// A world from a picture (.png, .pgm, .bmp): a pixel is floor that is opaque and brighter than
/// 0.804 of full white, ROS's bound by default. Throws as readWorld() does, and core::UsageError
/// for a resolution out of 0.01 to 0.5 m.
World readWorldPicture(const std::filesystem::path& path, double resolution_m);

/// A place to start where the world names none: the robot's disc, with a hand's breadth around it,
/// is on free floor, in the largest region that it can drive about in (a map holds pockets that
/// were seen and never entered). Drawn from the seed. Throws core::Error when there is no such
/// place.
mrpt::math::TPose2D drawStart(const World& world, double robot_radius_m, std::uint64_t seed);

}  // namespace ariadne::sim
