#include "ariadne/models/stamped_pose.h"

#include <algorithm>

namespace ariadne::models {

double durationOf(const Trajectory& path) {
  if (path.empty()) return 0;
  double seconds = path.back().time_s - path.front().time_s;
  for (std::size_t i = 1; i < path.size(); ++i)
    seconds += std::max(0.0, path[i - 1].time_s - path[i].time_s);
  return seconds;
}

Trajectory sortedByTime(Trajectory path) {
  std::stable_sort(path.begin(), path.end(),
                   [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  return path;
}

}  // namespace ariadne::models
