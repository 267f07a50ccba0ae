#include "rawlog_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;
using mrpt::poses::CPose3D;

constexpr std::uint32_t kMostBeams = 100'000;
constexpr std::int64_t kTicksTo1970 = 116'444'736'000'000'000;
constexpr long double kLatest_s = 1e11L;

template <class T>
double real(ArchiveReader& in) {
  return static_cast<double>(in.number<T>());
}

/// A matrix object of at most 16 x 16 numbers, row by row.
template <class T>
std::vector<double> readMatrix(ArchiveReader& in, const char* name) {
  const ObjectHeader object = in.header(name, 0);
  const auto rows = in.number<std::uint32_t>();
  const auto columns = in.number<std::uint32_t>();
  if (rows > 16 || columns > 16)
    throw ArchiveDamage(fmt::format("a matrix claims {} x {} numbers", rows, columns));
  std::vector<double> numbers(rows * columns);
  for (double& number : numbers) number = real<T>(in);
  in.end(object);
  return numbers;
}

CPose3D fromHomogeneous(const std::vector<double>& m) {
  if (m.size() != 16) throw ArchiveDamage("a pose's matrix is not 4 x 4");
  mrpt::math::CMatrixDouble44 matrix;
  for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = m[static_cast<std::size_t>(i)];
  return CPose3D(matrix);
}

CPose3D readPose3D(ArchiveReader& in) {
  const ObjectHeader object = in.header("CPose3D", 3);
  CPose3D pose;
  if (object.version == 0) {
    pose = fromHomogeneous(readMatrix<float>(in, "CMatrixF"));
  } else if (object.version == 1) {
    pose = fromHomogeneous(readMatrix<double>(in, "CMatrixD"));
  } else {
    std::array<double, 12> v{};
    const std::size_t count = object.version == 2 ? 7 : 12;
    for (std::size_t i = 0; i < count; ++i) v[i] = in.number<double>();
    mrpt::math::CMatrixDouble33 rotation;
    if (object.version == 3) {
      for (int i = 0; i < 9; ++i) rotation(i / 3, i % 3) = v[3 + static_cast<std::size_t>(i)];
    } else {  // a quaternion; the scan check finds one that is not of unit length
      const double r = v[3], x = v[4], y = v[5], z = v[6];
      const std::array<double, 9> m = {r * r + x * x - y * y - z * z, 2 * (x * y - r * z),
                                       2 * (z * x + r * y),           2 * (x * y + r * z),
                                       r * r - x * x + y * y - z * z, 2 * (y * z - r * x),
                                       2 * (z * x - r * y),           2 * (y * z + r * x),
                                       r * r - x * x - y * y + z * z};
      for (int i = 0; i < 9; ++i) rotation(i / 3, i % 3) = m[static_cast<std::size_t>(i)];
    }
    pose.setRotationMatrix(rotation);
    pose.x(v[0]);
    pose.y(v[1]);
    pose.z(v[2]);
  }
  in.end(object);
  return pose;
}

TPose2D readPose2D(ArchiveReader& in) {
  const ObjectHeader object = in.header("CPose2D", 1);
  std::array<double, 3> v{};
  for (double& number : v) number = object.version == 0 ? real<float>(in) : in.number<double>();
  in.end(object);
  return {v[0], v[1], v[2]};
}

/// Mean of weighted poses, the heading as a direction.
class MeanPose {
 public:
  void add(const TPose2D& pose, double log_weight) {
    const double w = std::exp(log_weight);
    sum_ += w;
    x_ += w * pose.x;
    y_ += w * pose.y;
    cos_ += w * std::cos(pose.phi);
    sin_ += w * std::sin(pose.phi);
  }
  TPose2D get() const { return {x_ / sum_, y_ / sum_, std::atan2(sin_, cos_)}; }

 private:
  double sum_ = 0, x_ = 0, y_ = 0, cos_ = 0, sin_ = 0;
};

/// Mean of a CPosePDF of any kind.
TPose2D readDensity(ArchiveReader& in) {
  const ObjectHeader object = in.header();
  TPose2D mean;
  if (object.name == "CPosePDFGaussian") {
    requireVersion(object, 2);
    mean = readPose2D(in);
    if (object.version == 0) readMatrix<float>(in, "CMatrixF");
    if (object.version > 0) in.bytes(6 * (object.version == 1 ? sizeof(float) : sizeof(double)));
  } else if (object.name == "CPosePDFGaussianInf") {
    requireVersion(object, 0);
    mean.x = in.number<double>();
    mean.y = in.number<double>();
    mean.phi = in.number<double>();
    in.bytes(6 * sizeof(double));
  } else if (object.name == "CPosePDFParticles" || object.name == "CPosePDFSOG") {
    const bool modes = object.name == "CPosePDFSOG";
    requireVersion(object, modes ? 2 : 1);
    MeanPose sum;
    for (auto left = in.number<std::uint32_t>(); left > 0; --left) {
      double weight = in.number<double>();
      if (modes && object.version == 0) weight = std::log(std::max(1e-300, weight));
      TPose2D pose;
      if (modes || object.version == 0) {
        pose = readPose2D(in);
      } else {
        pose.x = in.number<double>();
        pose.y = in.number<double>();
        pose.phi = in.number<double>();
      }
      if (modes) in.bytes(6 * (object.version == 1 ? sizeof(float) : sizeof(double)));
      sum.add(pose, weight);
    }
    mean = sum.get();
  } else {
    throw ArchiveDamage(fmt::format("{} where a pose density should be", object.name));
  }
  in.end(object);
  return mean;
}

}  // namespace

std::optional<double> secondsOfTicks(std::int64_t ticks) {
  if (ticks == 0) return std::nullopt;
  // A double has no room for today's ticks; and mrpt::Clock::toDouble wraps before 1970.
  const long double time_s =
      (static_cast<long double>(ticks) - static_cast<long double>(kTicksTo1970)) / 1e7L;
  if (std::abs(time_s) > kLatest_s) return std::nullopt;
  return static_cast<double>(time_s);
}

mrpt::Clock::time_point clockOfSeconds(double time_s) {
  const double whole = std::floor(time_s);
  return mrpt::Clock::time_point(
      mrpt::Clock::duration(kTicksTo1970 + static_cast<std::int64_t>(whole) * 10'000'000 +
                            std::llround((time_s - whole) * 1e7)));
}

LaserRecord readScan(ArchiveReader& in, const ObjectHeader& object) {
  requireVersion(object, 7);
  const int version = object.version;
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->aperture = in.number<float>();
  scan->rightToLeft = in.flag();
  scan->maxRange = in.number<float>();
  scan->sensorPose = readPose3D(in);
  if (version < 6) readMatrix<float>(in, "CMatrixF");  // the pose's covariance
  const auto count = in.number<std::uint32_t>();
  if (count > kMostBeams) throw ArchiveDamage(fmt::format("a scan claims {} beams", count));
  scan->resizeScan(count);
  const char* ranges = in.bytes(count * sizeof(float));
  if (count > 0) std::memcpy(&scan->getScanRange(0), ranges, count * sizeof(float));
  const char* valid = version > 0 ? in.bytes(count) : nullptr;
  for (std::uint32_t i = 0; i < count; ++i)
    scan->setScanRangeValidity(
        i, valid != nullptr ? valid[i] != 0 : scan->getScanRange(i) < scan->maxRange);
  if (version >= 2) scan->stdError = in.number<float>();
  LaserRecord record;
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
  in.end(object);
  record.scan = std::move(scan);
  return record;
}

OdometryReading readOdometry(ArchiveReader& in, const ObjectHeader& object) {
  requireVersion(object, 2);
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
  requireVersion(object, 7);
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
