// Principal axes of symmetric matrices of the plane.
#pragma once
#include <Eigen/Dense>

namespace ariadne::geometry {

/// Eigenvalues, the least first, and their eigenvectors of length 1, a column each.
struct Axes {
  Eigen::Vector2d values;
  Eigen::Matrix2d vectors;
};

/// Of a symmetric matrix; its lower triangle is read.
Axes axesOf(const Eigen::Matrix2d& symmetric);

}  // namespace ariadne::geometry
