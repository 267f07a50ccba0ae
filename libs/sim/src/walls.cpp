#include "ariadne/sim/walls.h"

#include <cmath>
#include <unordered_set>

#include "ariadne/geometry/pose.h"
#include "laser.h"

namespace ariadne::sim {
namespace {

/// The cell in which each beam of a scan that has a return ends.
template <class F>
void forEachEnd(const mrpt::obs::CObservation2DRangeScan& scan, const mrpt::math::TPose2D& pose,
                F&& f) {
  const std::size_t beams = scan.getScanSize();
  for (std::size_t i = 0; i < beams; ++i) {
    if (!scan.getScanRangeValidity(i)) continue;
    const double angle =
        pose.phi + scan.aperture * (static_cast<double>(i) / static_cast<double>(beams - 1) - 0.5);
    const double range_m = scan.getScanRange(i);
    f(pose.x + range_m * std::cos(angle), pose.y + range_m * std::sin(angle));
  }
}

}  // namespace

std::vector<std::size_t> keyMoments(const geometry::Trajectory& path) {
  constexpr double kMoved_m = 0.2;
  constexpr double kTurned = 0.17;
  std::vector<std::size_t> moments;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!moments.empty()) {
      const auto moved = geometry::relativePose(path[moments.back()].pose, path[i].pose);
      if (std::hypot(moved.x, moved.y) < kMoved_m && std::abs(moved.phi) < kTurned) continue;
    }
    moments.push_back(i);
  }
  return moments;
}

std::vector<mrpt::math::TPoint2D> wallsHit(const World& world, const geometry::Trajectory& truth,
                                           const DriveParams& params) {
  const auto& map = world.map;
  std::vector<mrpt::math::TPoint2D> walls;
  std::unordered_set<std::size_t> hit;
  for (const std::size_t k : keyMoments(truth)) {
    const auto& pose = truth[k].pose;
    forEachEnd(*scanFrom(world, pose, params), pose, [&](double x, double y) {
      const int ix = map.x2idx(x), iy = map.y2idx(y);
      if (ix < 0 || iy < 0 || ix >= static_cast<int>(map.getSizeX()) ||
          iy >= static_cast<int>(map.getSizeY()))
        return;
      const std::size_t cell = static_cast<std::size_t>(iy) * map.getSizeX() + ix;
      if (hit.insert(cell).second) walls.emplace_back(map.idx2x(ix), map.idx2y(iy));
    });
  }
  return walls;
}

}  // namespace ariadne::sim
