// A small filter on a known drive, and how far its path is from the truth.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "ariadne/geometry/pose.h"
#include "ariadne/geometry/trajectory.h"
#include "ariadne/slam/mapper.h"

namespace ariadne::test {

inline slam::SlamParams few(int particles = 8) {
  slam::SlamParams p;
  p.filter.particles = particles;
  return p;
}

/// Largest distance between the path and the truth, both seen from their first pose, m.
inline double worstError(const geometry::Trajectory& path,
                         const std::vector<mrpt::math::TPose2D>& truth) {
  double worst = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto a = geometry::relativePose(path[0].pose, path[i].pose);
    const auto b = geometry::relativePose(truth[0], truth[i]);
    worst = std::max(worst, std::hypot(a.x - b.x, a.y - b.y));
  }
  return worst;
}

}  // namespace ariadne::test
