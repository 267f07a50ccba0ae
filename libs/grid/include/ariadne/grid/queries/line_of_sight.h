// Straight lines through the grid: which cells they cross, and whether a wall is between.
// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", Eurographics 1987.
#pragma once
#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::grid {

/// Calls visit(cell) for every cell that the segment from a to b (m, map frame) crosses, in order,
/// both ends included, until visit returns false.
template <class Visit>
void traverse(const OccupancyGrid& grid, const mrpt::math::TPoint2D& a,
              const mrpt::math::TPoint2D& b, Visit&& visit);

/// True when every cell from a to b, both included, is known and free.
bool inSight(const OccupancyGrid& grid, const mrpt::math::TPoint2D& a,
             const mrpt::math::TPoint2D& b);

}  // namespace ariadne::grid

#include "ariadne/grid/queries/traverse_impl.h"
