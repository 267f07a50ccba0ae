#include "scan_check.h"

#include <algorithm>
#include <cmath>

namespace ariadne::io {
namespace {

constexpr double kFlat_rad = 5 * M_PI / 180;
constexpr double kFarthestMount_m = 100;

bool isRotation(const mrpt::math::CMatrixDouble33& r) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double dot = 0;
      for (int k = 0; k < 3; ++k) dot += r(i, k) * r(j, k);
      if (!(std::abs(dot - (i == j ? 1 : 0)) < 1e-3)) return false;
    }
  return true;
}

void countNoReturn(float range, float own_max_m, bool called_valid, const BeamLimits& limits,
                   DatasetCounts& counts) {
  if (range < own_max_m) {
    ++counts.beams_no_return;
    ++counts.beams_over_reach;
    if (range >= limits.reach_m) ++counts.no_return_codes_mm[std::lround(range * 1000)];
  } else {
    ++(called_valid && range > own_max_m ? counts.beams_out_of_range : counts.beams_no_return);
  }
}

}  // namespace

bool isPlanar(const mrpt::obs::CObservation2DRangeScan& scan) {
  return std::abs(scan.sensorPose.getRotationMatrix()(2, 2)) >= std::cos(kFlat_rad) &&
         std::abs(scan.deltaPitch) <= kFlat_rad;
}

bool repairGeometry(LaserRecord& laser) {
  auto& scan = *laser.scan;
  if (!(scan.maxRange > 0 && scan.maxRange <= 1000)) scan.maxRange = 80;
  if (!std::isfinite(scan.deltaPitch)) scan.deltaPitch = 0;
  const auto& pose = scan.sensorPose;
  const double away = std::abs(pose.x()) + std::abs(pose.y()) + std::abs(pose.z());
  // A turn and a bit: some drivers repeat the first beam at the end.
  return laser.beams.ranges_m.size() >= 2 && scan.aperture > 0 && scan.aperture < 2.1 * M_PI &&
         away < kFarthestMount_m && isRotation(pose.getRotationMatrix());
}

void setBeams(mrpt::obs::CObservation2DRangeScan& scan, RawBeams beams, const BeamLimits& limits,
              DatasetCounts& counts) {
  const float own_max_m = scan.maxRange;
  if (limits.max_range_m > 0) scan.maxRange = limits.max_range_m;
  const float reach_m = std::min(scan.maxRange, limits.reach_m);
  const std::size_t size = beams.ranges_m.size();
  counts.beams += size;
  for (std::size_t i = 0; i < size; ++i) {
    float& range = beams.ranges_m[i];
    const bool called = beams.valid[i] != 0;
    // What lies beyond the file's own maximum is called invalid for that reason alone.
    const bool believed = called || range >= own_max_m;
    const bool good = believed && range > 0 && range >= limits.min_range_m && range < reach_m;
    beams.valid[i] = good ? 1 : 0;
    if (good) continue;
    if (range >= reach_m) {
      countNoReturn(range, own_max_m, called, limits, counts);
      // Infinite is how ROS says "nothing there".
      range = std::isfinite(range) ? std::max(range, scan.maxRange) : scan.maxRange;
      continue;
    }
    if (std::isnan(range))
      ++counts.beams_nan;
    else if (range < 0)
      ++counts.beams_negative;
    else if (range == 0)
      ++counts.beams_zero;
    else if (called)
      ++counts.beams_too_near;
    else
      ++counts.beams_flagged;
    range = 0;
  }
  // All at once: MRPT checks the index at each access, which takes longer than all of the above.
  scan.loadFromVectors(size, beams.ranges_m.data(), beams.valid.data());
}

}  // namespace ariadne::io
