#include "scan_record.h"

#include <cmath>
#include <limits>

namespace ariadne::io::ros {
namespace {

constexpr float kFarthest_m = 1000;
constexpr float kUsualReach_m = 80;
constexpr double kSameAngle_rad = 1e-5;  // what rounding to float does to a sum of increments

struct Fan {
  double begin_rad = 0, end_rad = 0;  ///< first and last beam
};

/// The last beam is where the increments lead to. angle_max is the same to more digits, if it is
/// the same at all: some drivers have it a beam further on.
Fan fanOf(const LaserScan& scan) {
  const double begin = scan.angle_min;
  const double beams = static_cast<double>(scan.ranges.size());
  const double end = begin + static_cast<double>(scan.angle_increment) * (beams - 1);
  return {begin, std::abs(end - scan.angle_max) < kSameAngle_rad ? scan.angle_max : end};
}

}  // namespace

LaserRecord recordOf(const LaserScan& scan, const std::string& label,
                     const mrpt::poses::CPose3D& robot_from_laser) {
  LaserRecord record;
  record.scan = mrpt::obs::CObservation2DRangeScan::Create();
  auto& out = *record.scan;
  out.sensorLabel = label;
  const bool has_reach = scan.range_max > 0 && scan.range_max <= kFarthest_m;
  out.maxRange = has_reach ? scan.range_max : kUsualReach_m;
  const float range_min = scan.range_min > 0 ? scan.range_min : 0;
  const Fan fan = fanOf(scan);
  out.aperture = static_cast<float>(std::abs(fan.end_rad - fan.begin_rad));
  out.rightToLeft = fan.end_rad >= fan.begin_rad;
  // MRPT's beams are symmetric about the sensor's axis, so an uneven fan turns the sensor.
  const double middle = (fan.begin_rad + fan.end_rad) / 2;
  out.sensorPose = robot_from_laser;
  if (middle != 0) out.sensorPose += mrpt::poses::CPose3D(0, 0, 0, middle, 0, 0);
  auto& [ranges, valid] = record.beams;
  ranges = scan.ranges;
  valid.resize(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    valid[i] = ranges[i] >= range_min && ranges[i] < out.maxRange ? 1 : 0;
    // -inf is "too near": a positive range, but no positive number is near enough.
    if (ranges[i] == -std::numeric_limits<float>::infinity())
      ranges[i] = std::numeric_limits<float>::min();
  }
  return record;
}

}  // namespace ariadne::io::ros
