#include "scan_check.h"

#include <cmath>

namespace ariadne::io {
namespace {

constexpr double kFlat_rad = 5 * M_PI / 180;
constexpr double kFarthestLaser_m = 100;

bool isRotation(const mrpt::math::CMatrixDouble33& r) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double dot = 0;
      for (int k = 0; k < 3; ++k) dot += r(i, k) * r(j, k);
      if (!(std::abs(dot - (i == j ? 1 : 0)) < 1e-3)) return false;
    }
  return true;
}

}  // namespace

bool isPlanar(const mrpt::obs::CObservation2DRangeScan& scan) {
  return std::abs(scan.sensorPose.getRotationMatrix()(2, 2)) >= std::cos(kFlat_rad) &&
         std::abs(scan.deltaPitch) <= kFlat_rad;
}

bool repairGeometry(mrpt::obs::CObservation2DRangeScan& scan) {
  if (!(scan.maxRange > 0 && scan.maxRange <= 1000)) scan.maxRange = 80;
  if (!std::isfinite(scan.deltaPitch)) scan.deltaPitch = 0;
  const auto& pose = scan.sensorPose;
  const double away = std::abs(pose.x()) + std::abs(pose.y()) + std::abs(pose.z());
  // A turn and a bit: some drivers repeat the first beam at the end.
  return scan.getScanSize() >= 2 && scan.aperture > 0 && scan.aperture < 2.1 * M_PI &&
         away < kFarthestLaser_m && isRotation(pose.getRotationMatrix());
}

void checkBeams(mrpt::obs::CObservation2DRangeScan& scan, DatasetCounts& counts) {
  const std::size_t size = scan.getScanSize();
  counts.beams += size;
  for (std::size_t i = 0; i < size; ++i) {
    float& range = scan.getScanRange(i);
    const bool called_valid = scan.getScanRangeValidity(i);
    if (called_valid && range > 0 && range < scan.maxRange) continue;
    scan.setScanRangeValidity(i, false);
    if (range >= scan.maxRange) {
      ++(called_valid && range > scan.maxRange ? counts.beams_out_of_range
                                               : counts.beams_no_return);
      if (!std::isfinite(range)) range = scan.maxRange;  // how ROS says "nothing there"
      continue;
    }
    if (std::isnan(range))
      ++counts.beams_nan;
    else if (range < 0)
      ++counts.beams_negative;
    else if (range == 0)
      ++counts.beams_zero;
    else
      ++counts.beams_flagged;
    range = 0;
  }
}

}  // namespace ariadne::io
