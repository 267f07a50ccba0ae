#include "ariadne/geometry/covariance.h"

namespace ariadne::geometry {

using mrpt::math::TPose2D;

Eigen::Matrix3d turnedBy(double angle) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return rotation;
}

Eigen::Matrix3d composedCovariance(const TPose2D& a, const Eigen::Matrix3d& of_a, const TPose2D& b,
                                   const Eigen::Matrix3d& of_b) {
  const Eigen::Matrix3d rotation = turnedBy(a.phi);
  const Eigen::Vector3d moved = rotation * Eigen::Vector3d(b.x, b.y, 0);
  Eigen::Matrix3d by_a = Eigen::Matrix3d::Identity();
  by_a(0, 2) = -moved[1];
  by_a(1, 2) = moved[0];
  return by_a * of_a * by_a.transpose() + rotation * of_b * rotation.transpose();
}

}  // namespace ariadne::geometry
