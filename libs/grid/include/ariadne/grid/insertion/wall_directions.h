// Which way the walls of a scan run, and whether the scan can tell at all how far the robot went.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace ariadne::grid {

/// The walls that a scan shows, by their normals.
struct WallDirections {
  mrpt::math::TPoint2D axis{0,
                            0};  ///< unit vector, robot's frame: along which the scan tells least
  /// Mean squared part of the walls' normals along the axis, 0 to 0.5: 0 where all walls run along
  /// it. 0.5 where no wall could be told.
  double across = 0.5;
};

/// Normals from the ends within 0.3 m on the same surface. Corners and clutter count as walls of
/// all directions; an end that stands alone is left out.
/// @param ends of beams that returned, m, robot's frame
/// @param beams of each: ends of neighbouring beams may be of one surface
WallDirections wallDirections(const std::vector<mrpt::math::TPoint2D>& ends,
                              const std::vector<std::size_t>& beams);

}  // namespace ariadne::grid
