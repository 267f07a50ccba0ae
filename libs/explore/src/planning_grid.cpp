#include "ariadne/explore/planning_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ariadne::explore {

using mrpt::math::TPoint2D;

PlanningGrid::PlanningGrid(const grid::OccupancyGrid& map, double cell_m,
                           const std::vector<TPoint2D>& obstacles) {
  const int factor = std::max(1, static_cast<int>(std::lround(cell_m / map.resolution())));
  cell_m_ = factor * map.resolution();
  unit_m_ = cell_m_ / 3;
  const grid::CellBox box = map.knownBox();
  // Whole coarse cells from the map's cell 0, so that they stay where they are as the map grows.
  const auto below = [&](int v) {
    return static_cast<int>(std::floor(static_cast<double>(v) / factor)) * factor;
  };
  constexpr int kBorder = 2;
  first_ = {below(box.x0) - kBorder * factor, below(box.y0) - kBorder * factor};
  width_ = (box.x1 - first_.x + factor - 1) / factor + kBorder;
  height_ = (box.y1 - first_.y + factor - 1) / factor + kBorder;
  const TPoint2D centre = map.centreOf(first_);
  corner_ = {centre.x - map.resolution() / 2, centre.y - map.resolution() / 2};
  classify(map, factor);
  for (const TPoint2D& p : obstacles)
    if (const int i = indexOf(p); i >= 0) kinds_[i] = CellKind::occupied;
  wall_ = distancesTo(CellKind::occupied);
  unknown_ = distancesTo(CellKind::unknown);
}

void PlanningGrid::classify(const grid::OccupancyGrid& map, int factor) {
  std::vector<std::uint16_t> free(static_cast<std::size_t>(size()), 0);
  kinds_.assign(static_cast<std::size_t>(size()), CellKind::unknown);
  map.cells().forEachTile([&](int tx, int ty, const auto& tile) {
    for (int y = 0; y < grid::kTileCells; ++y) {
      const int row = (ty * grid::kTileCells + y - first_.y) / factor;
      if (ty * grid::kTileCells + y < first_.y || row >= height_) continue;
      for (int x = 0; x < grid::kTileCells; ++x) {
        const std::int8_t odds = tile[static_cast<std::size_t>(y) * grid::kTileCells + x];
        if (odds == 0) continue;
        const int i = row * width_ + (tx * grid::kTileCells + x - first_.x) / factor;
        if (odds > 0)
          ++free[i];
        else
          kinds_[i] = CellKind::occupied;
      }
    }
  });
  const int most = factor * factor / 2;
  for (int i = 0; i < size(); ++i)
    if (kinds_[i] == CellKind::unknown && free[i] > most) kinds_[i] = CellKind::free;
}

// Two passes of the chamfer distance 3-4 (Borgefors, 1986).
std::vector<std::uint16_t> PlanningGrid::distancesTo(CellKind kind) const {
  constexpr std::uint16_t kFar = std::numeric_limits<std::uint16_t>::max() - 4;
  std::vector<std::uint16_t> d(kinds_.size(), kFar);
  for (int i = 0; i < size(); ++i)
    if (kinds_[i] == kind) d[i] = 0;
  const auto relax = [&](int i, int offset, int step) {
    d[i] = static_cast<std::uint16_t>(std::min<int>(d[i], d[i + offset] + step));
  };
  for (int y = 1; y < height_ - 1; ++y)
    for (int x = 1; x < width_ - 1; ++x) {
      const int i = y * width_ + x;
      relax(i, -1, 3);
      relax(i, -width_, 3);
      relax(i, -width_ - 1, 4);
      relax(i, -width_ + 1, 4);
    }
  for (int y = height_ - 2; y > 0; --y)
    for (int x = width_ - 2; x > 0; --x) {
      const int i = y * width_ + x;
      relax(i, 1, 3);
      relax(i, width_, 3);
      relax(i, width_ + 1, 4);
      relax(i, width_ - 1, 4);
    }
  return d;
}

int PlanningGrid::indexOf(const TPoint2D& p) const {
  const double x = std::floor((p.x - corner_.x) / cell_m_);
  const double y = std::floor((p.y - corner_.y) / cell_m_);
  if (!(x >= 1 && y >= 1 && x < width_ - 1 && y < height_ - 1)) return -1;
  return static_cast<int>(y) * width_ + static_cast<int>(x);
}

TPoint2D PlanningGrid::centreOf(int cell) const {
  return {corner_.x + (cell % width_ + 0.5) * cell_m_, corner_.y + (cell / width_ + 0.5) * cell_m_};
}

bool PlanningGrid::sees(int from, int to) const {
  int x = from % width_;
  int y = from / width_;
  const int to_x = to % width_;
  const int to_y = to / width_;
  const int dx = std::abs(to_x - x);
  const int dy = -std::abs(to_y - y);
  const int step_x = x < to_x ? 1 : -1;
  const int step_y = y < to_y ? 1 : -1;
  for (int error = dx + dy;;) {  // Bresenham
    const int twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      x += step_x;
    }
    if (twice <= dx) {
      error += dx;
      y += step_y;
    }
    if (x == to_x && y == to_y) return true;
    if (kinds_[y * width_ + x] == CellKind::occupied) return false;
  }
}

}  // namespace ariadne::explore
