#include "ariadne/geometry/axes.h"

#include <algorithm>
#include <cmath>

namespace ariadne::geometry {

// What Eigen's compute() comes to, to the bit. It reduces a matrix to three diagonals first; two by
// two is that already, and that step's templates cost the compiler seconds in each library.
Axes axesOf(const Eigen::Matrix2d& symmetric) {
  const Eigen::Vector2d diagonal = symmetric.diagonal();
  const Eigen::Matrix<double, 1, 1> beside(symmetric(1, 0));
  double scale = std::max(diagonal.cwiseAbs().maxCoeff(), std::abs(beside[0]));
  if (scale == 0) scale = 1;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeFromTridiagonal(diagonal / scale, beside / scale);
  return {axes.eigenvalues() * scale, axes.eigenvectors()};
}

}  // namespace ariadne::geometry
