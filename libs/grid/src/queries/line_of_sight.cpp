#include "ariadne/grid/line_of_sight.h"

#include <algorithm>
#include <cmath>

namespace ariadne::grid {

using mrpt::math::TPoint2D;

std::optional<Cell> firstOccupied(const OccupancyGrid& grid, const TPoint2D& a, const TPoint2D& b) {
  std::optional<Cell> hit;
  traverse(grid, a, b, [&](Cell c) {
    if (grid.at(c) < 0) hit = c;
    return !hit;
  });
  return hit;
}

bool inSight(const OccupancyGrid& grid, const TPoint2D& a, const TPoint2D& b) {
  bool clear = true;
  traverse(grid, a, b, [&](Cell c) { return clear = grid.at(c) > 0; });
  return clear;
}

std::optional<double> castRay(const OccupancyGrid& grid, const TPoint2D& origin, double angle,
                              double max_range_m) {
  const TPoint2D direction(std::cos(angle), std::sin(angle));
  const auto cell = firstOccupied(grid, origin, origin + direction * max_range_m);
  if (!cell) return std::nullopt;
  // Where the beam enters the cell: the later of its two near borders.
  const TPoint2D centre = grid.centreOf(*cell);
  const double half = grid.resolution() / 2;
  const auto enters = [&](double from, double mid, double d) {
    return d == 0 ? 0.0 : (mid - from - std::copysign(half, d)) / d;
  };
  return std::clamp(
      std::max(enters(origin.x, centre.x, direction.x), enters(origin.y, centre.y, direction.y)),
      0.0, max_range_m);
}

}  // namespace ariadne::grid
