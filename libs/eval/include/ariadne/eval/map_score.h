// How well a map's walls lie on the true ones.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::eval {

/// Walls of a map against the true ones, each 0 to 1.
struct MapScore {
  double precision = 0;  ///< share of the map's within the tolerance of a true one
  double recall = 0;     ///< share of the true ones within the tolerance of one of the map's
  double f1 = 0;         ///< harmonic mean of both: doubled walls lower the one, missing the other
};

/// Centres of the occupied cells (log odds under 0), m, frame of the map.
std::vector<mrpt::math::TPoint2D> wallsOf(const grid::OccupancyGrid& map);

/// @param walls of the map, m, frame of the map
/// @param true_walls those that a robot could have seen, m, frame of the truth: from the world
///   itself (sim::wallsHit), since a grid that scans were put into has the faults of grids and
///   scans
/// @param truth_from_map where the map lies, for instance by alignment of the paths
/// @param cell_m distances are those between cells of this size in the frame of the truth
/// All zero when either has no wall.
MapScore mapScore(const std::vector<mrpt::math::TPoint2D>& walls,
                  const std::vector<mrpt::math::TPoint2D>& true_walls,
                  const mrpt::math::TPose2D& truth_from_map, double tolerance_m, double cell_m);

}  // namespace ariadne::eval
