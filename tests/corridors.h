// Maps of corridors, drawn cell by cell: free inside, walls one cell thick, unknown beyond.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::test {

/// Draws a free rectangle, m, with walls around what is not free yet.
inline void drawRoom(grid::OccupancyGrid& map, double x0, double y0, double x1, double y1) {
  const grid::Cell a = map.cellOf({x0, y0});
  const grid::Cell b = map.cellOf({x1, y1});
  for (int y = a.y - 1; y <= b.y + 1; ++y)
    for (int x = a.x - 1; x <= b.x + 1; ++x) {
      const bool inside = x >= a.x && x <= b.x && y >= a.y && y <= b.y;
      if (inside)
        map.set({x, y}, 100);
      else if (map.at({x, y}) == 0)
        map.set({x, y}, -100);
    }
}

/// A ring of corridors 2 m wide about a square block; its middle line is a square of `side` m with
/// a corner at (0, 0).
inline grid::OccupancyGrid ringMap(double side) {
  grid::OccupancyGrid map;
  drawRoom(map, -1, -1, side + 1, 1);
  drawRoom(map, side - 1, -1, side + 1, side + 1);
  drawRoom(map, -1, side - 1, side + 1, side + 1);
  drawRoom(map, -1, -1, 1, side + 1);
  return map;
}

/// Points every 0.4 m along the middle line of the ring, from (0, 0) along x first.
inline std::vector<mrpt::math::TPoint2D> ringPath(double side, double length) {
  std::vector<mrpt::math::TPoint2D> path;
  for (double s = 0; s < length; s += 0.4) {
    const double t = s - 4 * side * static_cast<int>(s / (4 * side));
    const double u = t - side * static_cast<int>(t / side);
    switch (static_cast<int>(t / side)) {
      case 0:
        path.emplace_back(u, 0.0);
        break;
      case 1:
        path.emplace_back(side, u);
        break;
      case 2:
        path.emplace_back(side - u, side);
        break;
      default:
        path.emplace_back(0.0, side - u);
    }
  }
  return path;
}

}  // namespace ariadne::test
