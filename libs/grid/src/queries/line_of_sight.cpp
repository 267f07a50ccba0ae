#include "ariadne/grid/queries/line_of_sight.h"

namespace ariadne::grid {

using mrpt::math::TPoint2D;

bool inSight(const OccupancyGrid& grid, const TPoint2D& a, const TPoint2D& b) {
  bool clear = true;
  traverse(grid, a, b, [&](Cell c) { return clear = grid.at(c) > 0; });
  return clear;
}

}  // namespace ariadne::grid
