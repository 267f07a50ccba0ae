#include "ariadne/geometry/trajectory.h"

#include <algorithm>

#include "ariadne/geometry/pose.h"

namespace ariadne::geometry {

double durationOf(const Trajectory& path) {
  if (path.empty()) return 0;
  double seconds = path.back().time_s - path.front().time_s;
  for (std::size_t i = 1; i < path.size(); ++i)
    seconds += std::max(0.0, path[i - 1].time_s - path[i].time_s);
  return seconds;
}

double lengthOf(const Trajectory& path) {
  double length_m = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length_m += distance(path[i].pose, path[i - 1].pose);
  return length_m;
}

Trajectory sortedByTime(Trajectory path) {
  std::stable_sort(path.begin(), path.end(),
                   [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  return path;
}

}  // namespace ariadne::geometry
