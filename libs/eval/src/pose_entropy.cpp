#include "ariadne/eval/pose_entropy.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/core/error.h"

namespace ariadne::eval {
namespace {

constexpr double kDegree = M_PI / 180;

void checkFloor(const EntropyFloor& floor) {
  if (!(floor.position_m > 0 && floor.heading_deg > 0))
    throw core::UsageError(
        fmt::format("entropy floor of {} m and {} deg: both must be over 0, or a single pose "
                    "has no finite entropy",
                    floor.position_m, floor.heading_deg));
}

Eigen::Matrix3d covarianceOf(const geometry::WeightedPoses& set) {
  double x = 0, y = 0, along = 0, across = 0;
  for (std::size_t i = 0; i < set.poses.size(); ++i) {
    const auto& p = set.poses[i];
    const double w = set.weights[i];
    x += w * p.x;
    y += w * p.y;
    along += w * std::cos(p.phi);
    across += w * std::sin(p.phi);
  }
  const double heading = std::atan2(across, along);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < set.poses.size(); ++i) {
    const auto& p = set.poses[i];
    const Eigen::Vector3d r(p.x - x, p.y - y, std::remainder(p.phi - heading, 2 * M_PI));
    covariance += set.weights[i] * r * r.transpose();
  }
  return covariance;
}

double entropyOfGaussian(Eigen::Matrix3d covariance, const EntropyFloor& floor) {
  covariance(0, 0) += floor.position_m * floor.position_m;
  covariance(1, 1) += floor.position_m * floor.position_m;
  covariance(2, 2) += std::pow(floor.heading_deg * kDegree, 2);
  // From the factors: the determinant itself of a long thin set loses its digits.
  const Eigen::Matrix3d root = covariance.llt().matrixL();
  const double half_log_det = std::log(root(0, 0)) + std::log(root(1, 1)) + std::log(root(2, 2));
  return 1.5 * std::log(2 * M_PI * M_E) + half_log_det;
}

}  // namespace

Eigen::Matrix3d poseCovariance(const geometry::WeightedPoses& set) {
  geometry::checkWeightedPoses(set);
  return covarianceOf(set);
}

double gaussianEntropy(const geometry::WeightedPoses& set, const EntropyFloor& floor) {
  checkFloor(floor);
  return entropyOfGaussian(poseCovariance(set), floor);
}

}  // namespace ariadne::eval
