#include "rawlog_objects.h"

#include <fmt/format.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "rawlog_by_mrpt.h"
#include "rawlog_poses.h"
#include "rawlog_versions.h"

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;

constexpr std::uint32_t kMostRawlogBeams = 100'000;
constexpr std::int64_t kTicksTo1970 = 116'444'736'000'000'000;
constexpr long double kLatestTick_s = 1e11L;

}  // namespace

std::optional<double> secondsOfTicks(std::int64_t ticks) {
  if (ticks == 0) return std::nullopt;
  // A double has no room for today's ticks; and mrpt::Clock::toDouble wraps before 1970.
  const long double time_s =
      (static_cast<long double>(ticks) - static_cast<long double>(kTicksTo1970)) / 1e7L;
  if (std::abs(time_s) > kLatestTick_s) return std::nullopt;
  return static_cast<double>(time_s);
}

mrpt::Clock::time_point clockOfSeconds(double time_s) {
  const double whole = std::floor(time_s);
  return mrpt::Clock::time_point(
      mrpt::Clock::duration(kTicksTo1970 + static_cast<std::int64_t>(whole) * 10'000'000 +
                            std::llround((time_s - whole) * 1e7)));
}

namespace {

/// Of a version that only the installed MRPT knows; throws NewerVersion when it does not either.
template <class Observation>
std::shared_ptr<Observation> readNewer(ArchiveReader& in, const ObjectHeader& object) {
  auto observation = Observation::Create();
  const std::size_t size = readByMrpt(*observation, object, in.beforeNextEntry());
  if (size == 0) requireVersion(object);
  in.bytes(size);
  return observation;
}

RawBeams beamsOf(const mrpt::obs::CObservation2DRangeScan& scan) {
  RawBeams beams;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    beams.ranges_m.push_back(scan.getScanRange(i));
    beams.valid.push_back(scan.getScanRangeValidity(i) ? 1 : 0);
  }
  return beams;
}

std::int64_t ticksOf(const mrpt::obs::CObservation& observation) {
  return observation.timestamp.time_since_epoch().count();
}

}  // namespace

LaserRecord readScan(ArchiveReader& in, const ObjectHeader& object) {
  if (object.version > newestKnown(object.name)) {
    const auto newer = readNewer<mrpt::obs::CObservation2DRangeScan>(in, object);
    LaserRecord record;
    record.scan = newer;
    record.beams = beamsOf(*newer);
    record.time_s = secondsOfTicks(ticksOf(*newer));
    return record;
  }
  requireVersion(object);
  const int version = object.version;
  LaserRecord record;
  auto& scan = record.scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->aperture = in.number<float>();
  scan->rightToLeft = in.flag();
  scan->maxRange = in.number<float>();
  scan->sensorPose = readPose3D(in);
  if (version < 6) passCovariance(in);  // the pose's covariance
  const auto count = in.number<std::uint32_t>();
  if (count > kMostRawlogBeams) throw ArchiveDamage(fmt::format("a scan claims {} beams", count));
  auto& [ranges, valid] = record.beams;
  ranges.resize(count);
  if (count > 0) std::memcpy(ranges.data(), in.bytes(count * sizeof(float)), count * sizeof(float));
  valid.resize(count);
  if (version > 0)
    std::copy_n(in.bytes(count), count, valid.begin());
  else
    for (std::uint32_t i = 0; i < count; ++i) valid[i] = ranges[i] < scan->maxRange ? 1 : 0;
  if (version >= 2) scan->stdError = in.number<float>();
  if (version >= 3) {
    const auto ticks = in.number<std::int64_t>();
    record.time_s = secondsOfTicks(ticks);
    scan->timestamp = mrpt::Clock::time_point(mrpt::Clock::duration(ticks));
  }
  if (version >= 4) scan->beamAperture = in.number<float>();
  if (version >= 5) {
    scan->sensorLabel = in.text();
    scan->deltaPitch = in.number<double>();
  }
  if (version >= 7 && in.flag()) in.bytes(count * sizeof(std::int32_t));  // intensities
  if (version >= 8) in.number<float>();                                   // how long a sweep takes
  in.end(object);
  return record;
}

OdometryReading readOdometry(ArchiveReader& in, const ObjectHeader& object) {
  if (object.version > newestKnown(object.name)) {
    const auto newer = readNewer<mrpt::obs::CObservationOdometry>(in, object);
    return {secondsOfTicks(ticksOf(*newer)), newer->odometry.asTPose(), newer->sensorLabel};
  }
  requireVersion(object);
  const int version = object.version;
  OdometryReading reading;
  reading.odom_from_robot = readPose2D(in);
  reading.label = in.text();
  reading.time_s = secondsOfTicks(in.number<std::int64_t>());
  if (version >= 1) {
    const bool ticks = in.flag();
    if (ticks || version < 2) in.bytes(2 * sizeof(std::int32_t));
    const bool velocities = in.flag();
    if (version < 2) in.bytes(2 * sizeof(float));
    if (version == 2 && velocities) in.bytes(3 * sizeof(double));
  }
  in.end(object);
  return reading;
}

Movement readMovement(ArchiveReader& in, const ObjectHeader& object) {
  requireVersion(object);
  const int version = object.version;
  constexpr int kOdometry = 0, kMatching = 1;
  Movement movement;
  TPose2D& motion = movement.increment.robot_from_next;
  int method = kOdometry;
  if (version <= 1) {
    motion = readDensity(in);
    method = in.number<std::int32_t>();
  } else {
    method = in.number<std::int32_t>();
    if (method == kOdometry) {
      // The increment itself: MRPT makes a density of it here, and with its particle model the
      // mean would be random. What follows describes that model.
      motion = readPose2D(in);
      in.bytes(version == 2   ? 44
               : version == 3 ? 4 + 5 * 4 + 4 + 4 * 4
               : version == 4 ? 4 + 6 * 4 + 4 + 4 * 4
                              : 4 + 6 * 4 + 4 + 6 * 4);
    } else {
      motion = readDensity(in);
    }
  }
  movement.from_matching = method == kMatching;
  if (version >= 1) {
    const bool velocities = in.flag();
    if (version < 7) in.bytes(2 * sizeof(float));
    if (version >= 7 && velocities) in.bytes(3 * sizeof(double));
    const bool ticks = in.flag();
    if (version < 7 || ticks) in.bytes(2 * sizeof(std::int32_t));
  }
  if (version >= 6) in.number<std::int64_t>();  // its stamp
  in.end(object);
  return movement;
}

}  // namespace ariadne::io
