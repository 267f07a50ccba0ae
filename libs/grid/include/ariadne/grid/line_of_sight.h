// Straight lines through the grid: which cells they cross, and whether a wall is between.
// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", Eurographics 1987.
#pragma once
#include <optional>

#include "ariadne/grid/occupancy_grid.h"

namespace ariadne::grid {

/// Calls visit(cell) for every cell that the segment from a to b (m, map frame) crosses, in order,
/// both ends included, until visit returns false.
template <class Visit>
void traverse(const OccupancyGrid& grid, const mrpt::math::TPoint2D& a,
              const mrpt::math::TPoint2D& b, Visit&& visit);

/// First occupied cell on the line from a to b, if any.
std::optional<Cell> firstOccupied(const OccupancyGrid& grid, const mrpt::math::TPoint2D& a,
                                  const mrpt::math::TPoint2D& b);

/// True when every cell from a to b, both included, is known and free.
bool inSight(const OccupancyGrid& grid, const mrpt::math::TPoint2D& a,
             const mrpt::math::TPoint2D& b);

/// Distance (m) a beam from `origin` in direction `angle` (rad, map frame) travels until it enters
/// an occupied cell; nothing when it meets none within max_range_m.
std::optional<double> castRay(const OccupancyGrid& grid, const mrpt::math::TPoint2D& origin,
                              double angle, double max_range_m);

}  // namespace ariadne::grid

#include "ariadne/grid/traverse_impl.h"
