// How well a map's walls lie on the true ones.
#pragma once
#include <mrpt/math/TPose2D.h>

#include "ariadne/grid/occupancy_grid.h"

namespace ariadne::eval {

/// Occupied cells (log odds under 0) of a map against those of the truth, each 0 to 1.
struct MapScore {
  double precision = 0;  ///< share of the map's within the tolerance of a true one
  double recall = 0;     ///< share of the true ones within the tolerance of one of the map's
  double f1 = 0;         ///< harmonic mean of both: doubled walls lower the one, missing the other
};

/// @param truth_from_map where the map lies, for instance by alignment of the paths
/// All zero when either has no occupied cell.
MapScore mapScore(const grid::OccupancyGrid& map, const grid::OccupancyGrid& truth,
                  const mrpt::math::TPose2D& truth_from_map, double tolerance_m);

}  // namespace ariadne::eval
