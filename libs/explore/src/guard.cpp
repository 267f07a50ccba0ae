#include "ariadne/explore/guard.h"

#include <algorithm>
#include <cmath>

namespace ariadne::explore {

using mrpt::math::TPoint2D;

std::vector<TPoint2D> hitsOf(const mrpt::obs::CObservation2DRangeScan& scan, double range_m) {
  std::vector<TPoint2D> hits;
  const std::size_t n = scan.getScanSize();
  const double step = n > 1 ? scan.aperture / static_cast<double>(n - 1) : 0;
  const double first = (scan.rightToLeft ? -0.5 : 0.5) * scan.aperture;
  const double yaw = scan.sensorPose.yaw();
  for (std::size_t i = 0; i < n; ++i) {
    const double range = scan.getScanRange(i);
    if (!scan.getScanRangeValidity(i) || !(range > 0 && range <= range_m)) continue;
    const double angle = yaw + first + (scan.rightToLeft ? 1 : -1) * step * static_cast<double>(i);
    hits.emplace_back(scan.sensorPose.x() + range * std::cos(angle),
                      scan.sensorPose.y() + range * std::sin(angle));
  }
  return hits;
}

bool blocked(const std::vector<TPoint2D>& hits, double ahead_m, const ExploreParams& params) {
  const double half_width = params.robot_radius_m + 0.02;
  return std::any_of(hits.begin(), hits.end(), [&](const TPoint2D& p) {
    if (std::abs(p.y) >= half_width || p.x <= 0) return false;
    // Where the disc's rim is at this side of the robot.
    const double rim = std::sqrt(half_width * half_width - p.y * p.y);
    return p.x < rim + ahead_m;
  });
}

}  // namespace ariadne::explore
