#include "rawlog_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;
using mrpt::poses::CPose3D;

template <class T>
double real(ArchiveReader& in) {
  return static_cast<double>(in.number<T>());
}

/// A matrix object of at most 16 x 16 numbers, row by row.
template <class T>
std::vector<double> readMatrix(ArchiveReader& in, const char* name) {
  const ObjectHeader object = in.header(name);
  const auto rows = in.number<std::uint32_t>();
  const auto columns = in.number<std::uint32_t>();
  if (rows > 16 || columns > 16)
    throw ArchiveDamage(fmt::format("a matrix claims {} x {} numbers", rows, columns));
  std::vector<double> numbers(std::size_t{rows} * columns);
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

}  // namespace

CPose3D readPose3D(ArchiveReader& in) {
  const ObjectHeader object = in.header("CPose3D");
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

void passCovariance(ArchiveReader& in) { readMatrix<float>(in, "CMatrixF"); }

TPose2D readPose2D(ArchiveReader& in) {
  const ObjectHeader object = in.header("CPose2D");
  std::array<double, 3> v{};
  for (double& number : v) number = object.version == 0 ? real<float>(in) : in.number<double>();
  in.end(object);
  return {v[0], v[1], v[2]};
}

namespace {

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

}  // namespace

TPose2D readDensity(ArchiveReader& in) {
  const ObjectHeader object = in.header();
  TPose2D mean;
  if (object.name == "CPosePDFGaussian") {
    requireVersion(object);
    mean = readPose2D(in);
    if (object.version == 0) passCovariance(in);
    if (object.version > 0) in.bytes(6 * (object.version == 1 ? sizeof(float) : sizeof(double)));
  } else if (object.name == "CPosePDFGaussianInf") {
    requireVersion(object);
    mean.x = in.number<double>();
    mean.y = in.number<double>();
    mean.phi = in.number<double>();
    in.bytes(6 * sizeof(double));
  } else if (object.name == "CPosePDFParticles" || object.name == "CPosePDFSOG") {
    const bool modes = object.name == "CPosePDFSOG";
    requireVersion(object);
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

TPose2D readDensity3D(ArchiveReader& in) {
  const ObjectHeader object = in.header();
  TPose2D mean;
  if (object.name == "CPose3DPDFGaussian" || object.name == "CPose3DPDFGaussianInf") {
    requireVersion(object);
    if (object.name == "CPose3DPDFGaussian" && object.version == 0)
      throw ArchiveDamage("CPose3DPDFGaussian of version 0, which MRPT does not read either");
    mean = TPose2D(readPose3D(in).asTPose());
    in.bytes(21 * sizeof(double));  // of a symmetric 6 x 6
  } else if (object.name == "CPose3DPDFParticles") {
    requireVersion(object);
    MeanPose sum;
    auto left = in.number<std::uint32_t>();
    if (left == 0) throw ArchiveDamage("a pose without particles");
    for (; left > 0; --left) {
      const double log_weight = in.number<double>();
      std::array<double, 6> v{};  // x, y, z, yaw, pitch, roll
      if (object.version == 0) {
        const TPose2D pose(readPose3D(in).asTPose());
        v = {pose.x, pose.y, 0, pose.phi, 0, 0};
      } else {
        for (double& number : v) number = in.number<double>();
      }
      sum.add({v[0], v[1], v[3]}, log_weight);
    }
    mean = sum.get();
  } else {
    throw ArchiveDamage(
        fmt::format("{} where a CPose3DPDFGaussian or CPose3DPDFParticles should be", object.name));
  }
  in.end(object);
  return mean;
}

}  // namespace ariadne::io
