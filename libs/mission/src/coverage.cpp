#include "ariadne/mission/coverage.h"

#include "ariadne/core/error.h"
#include "ariadne/mission/reachable.h"
#include "ariadne/sim/robot.h"
#include "ariadne/sim/walls.h"

namespace ariadne::mission {
namespace {

using grid::OccupancyGrid;
using mrpt::math::TPose2D;

grid::GridParams paramsFor(double resolution_m, double range_m) {
  grid::GridParams p;
  p.resolution_m = resolution_m;
  p.insert_range_m = range_m;
  p.no_return_free_m = range_m;
  return p;
}

}  // namespace

OccupancyGrid seeable(const sim::World& world, const TPose2D& start, const sim::DriveParams& params,
                      double resolution_m) {
  constexpr double kApart_m = 0.5;
  sim::DriveParams all_around = params;
  all_around.field_of_view_deg = 360;
  all_around.beams = 721;
  const grid::GridParams grid = paramsFor(resolution_m, params.max_range_m);
  OccupancyGrid out(grid);
  for (const auto& at : reachablePlaces(world, start, params.robot_radius_m, kApart_m)) {
    const TPose2D pose{at.x, at.y, 0};
    out.insert(grid::makeScanShape(*sim::Robot(world, pose, all_around).scan(), grid), pose);
  }
  return out;
}

OccupancyGrid sighted(const std::vector<models::SensorStep>& steps,
                      const geometry::Trajectory& truth, double resolution_m) {
  OccupancyGrid out(paramsFor(resolution_m, 30));
  for (const std::size_t i : sim::keyMoments(truth)) {
    const auto grid = paramsFor(resolution_m, steps[i].scan->maxRange);
    out.insert(grid::makeScanShape(*steps[i].scan, grid), truth[i].pose);
  }
  return out;
}

double coverage(const sim::World& world, const OccupancyGrid& seeable,
                const OccupancyGrid& sighted) {
  std::size_t free = 0;
  std::size_t known = 0;
  seeable.cells().forEachTile([&](int tx, int ty, const auto& tile) {
    const auto* packed = sighted.cells().tile(tx, ty);
    grid::EvidencePlane::Cells other{};
    if (packed) other = sighted.cells().cellsOf(*packed);
    for (int i = 0; i < static_cast<int>(tile.size()); ++i) {
      if (tile[i] <= 0) continue;
      const auto at = seeable.centreOf({tx * grid::kTileCells + i % grid::kTileCells,
                                        ty * grid::kTileCells + i / grid::kTileCells});
      if (world.map.getPos(static_cast<float>(at.x), static_cast<float>(at.y)) < 0.9F) continue;
      ++free;
      known += other[i] != 0;
    }
  });
  return free > 0 ? static_cast<double>(known) / static_cast<double>(free) : 1;
}

}  // namespace ariadne::mission
