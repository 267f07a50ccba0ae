#include "ariadne/grid/insertion/wall_directions.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "ariadne/geometry/axes.h"

namespace ariadne::grid {
namespace {

using mrpt::math::TPoint2D;

constexpr double kSurface_m = 0.3;  // reach of a surface about an end
constexpr double kFlat_m = 0.04;    // root mean square off its line
constexpr std::size_t kFewestEnds = 10;

/// Count, sums and sums of squares of points; a run of ends is the difference of two.
struct Sums {
  double n = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();

  Sums plus(const Eigen::Vector2d& p) const {
    return {n + 1, sum + p, squares + p * p.transpose()};
  }
  Sums minus(const Sums& o) const { return {n - o.n, sum - o.sum, squares - o.squares}; }
  Eigen::Matrix2d covariance() const {
    const Eigen::Vector2d mean = sum / n;
    return squares / n - mean * mean.transpose();
  }
};

/// n n' of the surface with this covariance; of no direction where it is not flat.
Eigen::Matrix2d normalSquared(const Eigen::Matrix2d& covariance) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(covariance);
  if (axes.eigenvalues()[0] > kFlat_m * kFlat_m) return 0.5 * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d normal = axes.eigenvectors().col(0);
  return normal * normal.transpose();
}

}  // namespace

WallDirections wallDirections(const std::vector<TPoint2D>& ends,
                              const std::vector<std::size_t>& beams) {
  std::vector<Sums> upTo{Sums()};  // the first k ends
  upTo.reserve(ends.size() + 1);
  for (const TPoint2D& p : ends) upTo.push_back(upTo.back().plus({p.x, p.y}));
  const auto apart = [&](std::size_t a, std::size_t b) { return (ends[a] - ends[b]).norm(); };
  const auto joined = [&](std::size_t k) {  // k and the end before it are of one surface
    return beams[k] - beams[k - 1] == 1 && apart(k, k - 1) < kSurface_m;
  };
  Eigen::Matrix2d normals = Eigen::Matrix2d::Zero();
  std::size_t told = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    std::size_t first = i, last = i;
    while (first > 0 && joined(first) && apart(first - 1, i) < kSurface_m) --first;
    while (last + 1 < ends.size() && joined(last + 1) && apart(last + 1, i) < kSurface_m) ++last;
    if (last - first < 2) continue;
    normals += normalSquared(upTo[last + 1].minus(upTo[first]).covariance());
    ++told;
  }
  if (told < kFewestEnds) return {};
  const geometry::Axes axes = geometry::axesOf(normals / static_cast<double>(told));
  const Eigen::Vector2d axis = axes.vectors.col(0);
  return {{axis[0], axis[1]}, std::max(0.0, axes.values[0])};
}

}  // namespace ariadne::grid
