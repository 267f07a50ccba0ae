// The sparse Gaussian over the keyframes of a path: motions from one to the next, and ties between
// them; its mean, and samples of it.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ariadne/core/random.h"

namespace ariadne::loops {

inline Eigen::Vector3d vectorOf(const mrpt::math::TPose2D& p) { return {p.x, p.y, p.phi}; }

/// A relative pose of node b seen from node a; a < 0 is the fixed pose.
struct Factor {
  int a;
  mrpt::math::TPose2D fixed;
  int b;
  Eigen::Vector3d measured;
  Eigen::Matrix3d information;
  bool doubted;  ///< its weight falls when the others disagree
};

class Chain {
 public:
  explicit Chain(std::size_t nodes) : poses_(nodes) {}
  std::vector<mrpt::math::TPose2D>& poses() { return poses_; }
  std::vector<Factor>& factors() { return factors_; }

  /// Gauss-Newton. Throws std::runtime_error when the problem is singular.
  void optimise(int rounds);
  /// Half the squared Mahalanobis distance of the poses from what was measured.
  double cost() const;
  /// Moves every measurement by its own noise; the mean is a sample then (perturb and optimise).
  void perturb(core::RandomStream& rng);

 private:
  double step();
  const mrpt::math::TPose2D& from(const Factor& f) const {
    return f.a < 0 ? f.fixed : poses_[static_cast<std::size_t>(f.a)];
  }
  const mrpt::math::TPose2D& to(const Factor& f) const {
    return poses_[static_cast<std::size_t>(f.b)];
  }

  std::vector<mrpt::math::TPose2D> poses_;
  std::vector<Factor> factors_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  std::size_t analysed_ = 0;  // factors that the solver's pattern is of
};

}  // namespace ariadne::loops
