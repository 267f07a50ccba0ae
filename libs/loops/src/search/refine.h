// From a cell of the search to a pose: the piece laid over the scans that saw the place before.
#pragma once
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/loops/search/track.h"

namespace ariadne::loops {

struct Refined {
  mrpt::math::TPose2D map_from_piece;
  double field = 0;          ///< mean of the likelihood field under the piece's points, 0 to 1
  double known_share = 0;    ///< of the points lie where the map is known
  double contradicting = 0;  ///< share of the known ones that lie where the map is surely free
};

/// Climbs the likelihood field from `start` in steps down to half a cell.
Refined refine(const grid::OccupancyGrid& map, const std::vector<mrpt::math::TPoint2D>& points,
               const mrpt::math::TPose2D& start);

}  // namespace ariadne::loops
