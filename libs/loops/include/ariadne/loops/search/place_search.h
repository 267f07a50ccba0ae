// Where in a known map a piece of path was driven: near a place that is said, or anywhere.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::loops {

/// A pose of the piece and how well it fits there.
struct FoundPlace {
  mrpt::math::TPose2D map_from_piece;
  double field = 0;          ///< mean of the likelihood field under the piece's points, 0 to 1
  double known_share = 0;    ///< of the points lie where the map is known
  double contradicting = 0;  ///< share of the known ones that lie where the map is surely free
};

/// The best places over the whole map, best first, at most `count`, 1 m or 15 degrees apart from
/// each other. Those where the map does not show free space about the laser are left out: walls fit
/// from their other side, too.
/// @param points of the piece, m, piece's frame; 1 to 255
/// @param laser where it was at the first scan, m, piece's frame. The robot's own centre may lie
///   behind all that a laser looking ahead has seen.
std::vector<FoundPlace> searchPlaces(const grid::OccupancyGrid& map,
                                     const std::vector<mrpt::math::TPoint2D>& points,
                                     const mrpt::math::TPoint2D& laser, std::size_t count);

/// The best place within 1 m and 15 degrees of `expected`.
FoundPlace placeNear(const grid::OccupancyGrid& map,
                     const std::vector<mrpt::math::TPoint2D>& points,
                     const mrpt::math::TPose2D& expected);

}  // namespace ariadne::loops
