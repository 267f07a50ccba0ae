#include "ariadne/eval/map_score.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ariadne/geometry/pose.h"

namespace ariadne::eval {
namespace {

using grid::OccupancyGrid;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// All points within the tolerance of some given ones, to the cell.
class Near {
 public:
  Near(const std::vector<TPoint2D>& points, double tolerance_m, double cell_m) : cell_m_(cell_m) {
    const int reach = static_cast<int>(tolerance_m / cell_m);
    for (const TPoint2D& p : points)
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
          if (std::hypot(dx, dy) * cell_m <= tolerance_m)
            marked_.set(cell(p.x) + dx, cell(p.y) + dy, 1);
  }

  double shareOf(const std::vector<TPoint2D>& points) const {
    const auto hits = std::count_if(points.begin(), points.end(), [&](const TPoint2D& p) {
      return marked_.at(cell(p.x), cell(p.y)) != 0;
    });
    return static_cast<double>(hits) / static_cast<double>(points.size());
  }

 private:
  int cell(double v) const { return static_cast<int>(std::floor(v / cell_m_)); }

  double cell_m_;
  grid::TiledPlane<std::uint8_t> marked_;
};

}  // namespace

std::vector<TPoint2D> wallsOf(const OccupancyGrid& map) {
  std::vector<TPoint2D> walls;
  map.cells().forEachTile([&](int tx, int ty, const auto& tile) {
    for (int y = 0; y < grid::kTileCells; ++y)
      for (int x = 0; x < grid::kTileCells; ++x)
        if (tile[static_cast<std::size_t>(y) * grid::kTileCells + x] < 0)
          walls.push_back(map.centreOf({tx * grid::kTileCells + x, ty * grid::kTileCells + y}));
  });
  return walls;
}

MapScore mapScore(const std::vector<TPoint2D>& walls, const std::vector<TPoint2D>& true_walls,
                  const TPose2D& truth_from_map, double tolerance_m, double cell_m) {
  MapScore score;
  if (walls.empty() || true_walls.empty()) return score;
  const std::vector<TPoint2D> placed = geometry::placed(truth_from_map, walls);
  score.precision = Near(true_walls, tolerance_m, cell_m).shareOf(placed);
  score.recall = Near(placed, tolerance_m, cell_m).shareOf(true_walls);
  const double sum = score.precision + score.recall;
  if (sum > 0) score.f1 = 2 * score.precision * score.recall / sum;
  return score;
}

}  // namespace ariadne::eval
