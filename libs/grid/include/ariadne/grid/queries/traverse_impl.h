// The walk behind line_of_sight.h.
#pragma once
#include <cmath>
#include <limits>

namespace ariadne::grid {

/// One axis of the walk: the share t in [0, 1] of the segment at which the next border is crossed.
struct TraverseAxis {
  /// @param from, to in cells; @param cell the one that `from` lies in
  TraverseAxis(double from, double to, int cell)
      : step(to > from ? 1 : -1),
        per_cell(to == from ? std::numeric_limits<double>::infinity() : 1 / std::abs(to - from)),
        next(to == from ? std::numeric_limits<double>::infinity()
                        : (to > from ? cell + 1 - from : from - cell) * per_cell) {}
  int step;
  double per_cell;
  double next;
};

template <class Visit>
void traverse(const OccupancyGrid& grid, const mrpt::math::TPoint2D& a,
              const mrpt::math::TPoint2D& b, Visit&& visit) {
  const auto scaled = [&](const mrpt::math::TPoint2D& p) {
    return mrpt::math::TPoint2D((p.x - grid.origin().x) / grid.resolution(),
                                (p.y - grid.origin().y) / grid.resolution());
  };
  const auto from = scaled(a);
  const auto to = scaled(b);
  Cell cell{static_cast<int>(std::floor(from.x)), static_cast<int>(std::floor(from.y))};
  const Cell last{static_cast<int>(std::floor(to.x)), static_cast<int>(std::floor(to.y))};
  TraverseAxis x(from.x, to.x, cell.x);
  TraverseAxis y(from.y, to.y, cell.y);
  // The number of borders is known beforehand, so rounding cannot make the walk miss its end.
  int left_x = std::abs(last.x - cell.x);
  int left_y = std::abs(last.y - cell.y);
  while (visit(cell) && (left_x > 0 || left_y > 0)) {
    const bool along_x = left_y == 0 || (left_x > 0 && x.next <= y.next);
    TraverseAxis& axis = along_x ? x : y;
    axis.next += axis.per_cell;
    (along_x ? cell.x : cell.y) += axis.step;
    --(along_x ? left_x : left_y);
  }
}

}  // namespace ariadne::grid
