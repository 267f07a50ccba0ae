#include "refine.h"

#include "ariadne/geometry/pose.h"

namespace ariadne::loops {
namespace {

using mrpt::math::TPose2D;
using Points = std::vector<mrpt::math::TPoint2D>;

double meanField(const grid::OccupancyGrid& map, const Points& points, const TPose2D& pose) {
  double sum = 0;
  for (const auto& p : geometry::placed(pose, points)) sum += map.fieldAt(map.cellOf(p));
  return sum / 255 / static_cast<double>(points.size());
}

}  // namespace

Refined refine(const grid::OccupancyGrid& map, const Points& points, const TPose2D& start) {
  Refined out{start, -1, 0, 0};
  constexpr int kReach = 2;
  double turn = 0.4 * M_PI / 180;
  for (double step = 0.1; step > 0.4 * map.resolution(); step /= 2, turn /= 2) {
    const TPose2D about = out.map_from_piece;
    for (int a = -kReach; a <= kReach; ++a)
      for (int i = -kReach; i <= kReach; ++i)
        for (int j = -kReach; j <= kReach; ++j) {
          const TPose2D pose(about.x + i * step, about.y + j * step, about.phi + a * turn);
          const double field = meanField(map, points, pose);
          if (field <= out.field) continue;
          out.field = field;
          out.map_from_piece = pose;
        }
  }
  std::size_t known = 0, against = 0;
  for (const auto& p : geometry::placed(out.map_from_piece, points)) {
    const grid::Cell cell = map.cellOf(p);
    const bool wall_near = map.fieldAt(cell) > 0;
    if (map.at(cell) == 0 && !wall_near) continue;
    ++known;
    against += map.at(cell) > 0 && !wall_near;
  }
  out.known_share = static_cast<double>(known) / static_cast<double>(points.size());
  out.contradicting = known == 0 ? 0 : static_cast<double>(against) / static_cast<double>(known);
  return out;
}

}  // namespace ariadne::loops
