#include "ariadne/eval/path_passes.h"

#include <algorithm>
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::eval {
namespace {

struct Place {
  double x;
  double y;
};

/// Earlier visits to point i: points near it, more than apart_m before it, and as far from the
/// visit counted before.
std::size_t passesBefore(const std::vector<PathPoint>& points, const std::vector<Place>& places,
                         std::size_t i, const PassParams& p) {
  std::size_t passes = 0;
  double next_visit = points[i].travelled_m;
  for (std::size_t j = i; j-- > 0;) {
    if (geometry::distance(places[j], places[i]) >= p.near_m) continue;
    if (points[i].travelled_m - points[j].travelled_m <= p.apart_m) continue;
    if (next_visit - points[j].travelled_m > p.apart_m) ++passes;
    next_visit = points[j].travelled_m;
  }
  return passes;
}

}  // namespace

std::vector<PathPoint> pathPasses(const geometry::Trajectory& path, const PassParams& p) {
  if (path.empty()) throw core::UsageError("a path without a pose has no passes");
  if (!(p.near_m > 0 && p.apart_m > 0 && p.every_m > 0))
    throw core::UsageError("near_m, apart_m and every_m must be over 0");
  std::vector<PathPoint> points{{path[0].time_s, 0, 0}};
  std::vector<Place> places{{path[0].pose.x, path[0].pose.y}};
  double travelled_m = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = geometry::distance(path[i - 1].pose, path[i].pose);
    const int parts = std::max(1, static_cast<int>(length / p.every_m));
    for (int k = 1; k <= parts; ++k) {
      const double u = static_cast<double>(k) / parts;
      points.push_back({path[i - 1].time_s + u * (path[i].time_s - path[i - 1].time_s),
                        travelled_m + u * length, 0});
      places.push_back({path[i - 1].pose.x + u * (path[i].pose.x - path[i - 1].pose.x),
                        path[i - 1].pose.y + u * (path[i].pose.y - path[i - 1].pose.y)});
    }
    travelled_m += length;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i].passes = passesBefore(points, places, i, p);
  return points;
}

const PathPoint& pointAt(const std::vector<PathPoint>& points, double time_s) {
  const auto after = std::lower_bound(points.begin(), points.end(), time_s,
                                      [](const PathPoint& p, double t) { return p.time_s < t; });
  if (after == points.begin()) return points.front();
  if (after == points.end()) return points.back();
  const auto before = after - 1;
  return after->time_s - time_s < time_s - before->time_s ? *after : *before;
}

}  // namespace ariadne::eval
