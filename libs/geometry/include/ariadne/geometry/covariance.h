// Covariances of motions in the plane, (x, y, heading), m and rad.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>

namespace ariadne::geometry {

/// Turns (x, y, heading) by an angle, rad.
Eigen::Matrix3d turnedBy(double angle);

/// Covariance of a (+) b in the frame that a starts in, from those of a and b, each in its own.
Eigen::Matrix3d composedCovariance(const mrpt::math::TPose2D& a, const Eigen::Matrix3d& of_a,
                                   const mrpt::math::TPose2D& b, const Eigen::Matrix3d& of_b);

}  // namespace ariadne::geometry
