#include "ariadne/explore/goal_check.h"

#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

using mrpt::math::TPoint2D;

/// Calls f(log odds) for the map's cells whose centres are within `reach_m` of the point.
template <class F>
void forEachNear(const grid::OccupancyGrid& map, const TPoint2D& point, double reach_m, F&& f) {
  const grid::Cell centre = map.cellOf(point);
  const int reach = static_cast<int>(std::ceil(reach_m / map.resolution()));
  for (int y = centre.y - reach; y <= centre.y + reach; ++y)
    for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
      const TPoint2D at = map.centreOf({x, y});
      if (geometry::distance(at, point) <= reach_m) f(map.at({x, y}));
    }
}

}  // namespace

bool routeHolds(const grid::OccupancyGrid& map, const Route& route, std::size_t next,
                const mrpt::math::TPose2D& robot, const ExploreParams& params) {
  constexpr double kOff_m = 0.8;
  constexpr double kLookahead_m = 6;
  constexpr double kEvery_m = 0.15;
  if (next >= route.size()) return false;
  if (geometry::distance(route[next], robot) > kOff_m) return false;
  double ahead_m = 0;
  double looked = -kEvery_m;
  for (std::size_t i = next; i < route.size() && ahead_m < kLookahead_m; ++i) {
    if (i > next) ahead_m += geometry::distance(route[i], route[i - 1]);
    if (ahead_m - looked < kEvery_m) continue;
    looked = ahead_m;
    bool wall = false;
    forEachNear(map, route[i], params.robot_radius_m, [&](std::int8_t odds) { wall |= odds < 0; });
    if (wall) return false;
  }
  return true;
}

bool bordersUnknown(const grid::OccupancyGrid& map, const TPoint2D& point, double reach_m) {
  constexpr int kFew = 3;
  int unknown = 0;
  forEachNear(map, point, reach_m, [&](std::int8_t odds) { unknown += odds == 0; });
  return unknown >= kFew;
}

double freeArea(const grid::OccupancyGrid& map, const TPoint2D& point, double reach_m) {
  int cells = 0;
  forEachNear(map, point, reach_m, [&](std::int8_t odds) { cells += odds > 0; });
  return cells * map.resolution() * map.resolution();
}

}  // namespace ariadne::explore
