#include "chain.h"

#include <stdexcept>

namespace ariadne::loops {
namespace {

using mrpt::math::TPose2D;

constexpr double kDoubt = 9;  // squared Mahalanobis distance from which a tie is doubted

TPose2D poseOf(const Eigen::Vector3d& v) { return {v[0], v[1], std::remainder(v[2], 2 * M_PI)}; }

struct Linearised {
  Eigen::Vector3d error;
  Eigen::Matrix3d by_a;
  Eigen::Matrix3d by_b;
};

Linearised linearise(const TPose2D& pa, const TPose2D& pb, const Eigen::Vector3d& measured) {
  const double c = std::cos(pa.phi), s = std::sin(pa.phi), dx = pb.x - pa.x, dy = pb.y - pa.y;
  Linearised out;
  out.error = {c * dx + s * dy - measured[0], -s * dx + c * dy - measured[1],
               std::remainder(pb.phi - pa.phi - measured[2], 2 * M_PI)};
  out.by_a << -c, -s, -s * dx + c * dy, s, -c, -c * dx - s * dy, 0, 0, -1;
  out.by_b << c, s, 0, -s, c, 0, 0, 0, 1;
  return out;
}

}  // namespace

void Chain::optimise(int rounds) {
  for (int round = 0; round < rounds; ++round)
    if (step() < 1e-4) break;
}

double Chain::cost() const {
  double sum = 0;
  for (const Factor& f : factors_) {
    const Eigen::Vector3d e = linearise(from(f), to(f), f.measured).error;
    const double chi2 = e.dot(f.information * e);
    sum += f.doubted ? kDoubt * std::log1p(chi2 / kDoubt) : chi2;
  }
  return 0.5 * sum;
}

void Chain::perturb(core::RandomStream& rng) {
  for (Factor& f : factors_) {
    const Eigen::Matrix3d covariance = f.information.inverse();
    const Eigen::Matrix3d root = covariance.llt().matrixL();
    const double a = rng.gaussian(), b = rng.gaussian(), c = rng.gaussian();
    f.measured += root * Eigen::Vector3d(a, b, c);
  }
}

double Chain::step() {
  const auto n = static_cast<Eigen::Index>(3 * poses_.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(factors_.size() * 36);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  const auto put = [&](int row, int column, const Eigen::Matrix3d& m) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) entries.emplace_back(3 * row + i, 3 * column + k, m(i, k));
  };
  for (const Factor& f : factors_) {
    const Linearised l = linearise(from(f), to(f), f.measured);
    Eigen::Matrix3d weight = f.information;
    if (f.doubted) weight /= 1 + l.error.dot(f.information * l.error) / kDoubt;
    put(f.b, f.b, l.by_b.transpose() * weight * l.by_b);
    gradient.segment<3>(3 * f.b) -= l.by_b.transpose() * weight * l.error;
    if (f.a < 0) continue;
    put(f.a, f.a, l.by_a.transpose() * weight * l.by_a);
    put(f.a, f.b, l.by_a.transpose() * weight * l.by_b);
    put(f.b, f.a, l.by_b.transpose() * weight * l.by_a);
    gradient.segment<3>(3 * f.a) -= l.by_a.transpose() * weight * l.error;
  }
  Eigen::SparseMatrix<double> hessian(n, n);
  hessian.setFromTriplets(entries.begin(), entries.end());
  if (analysed_ != factors_.size()) solver_.analyzePattern(hessian);
  analysed_ = factors_.size();
  solver_.factorize(hessian);
  if (solver_.info() != Eigen::Success) throw std::runtime_error("closure: the chain is singular");
  const Eigen::VectorXd by = solver_.solve(gradient);
  for (std::size_t k = 0; k < poses_.size(); ++k)
    poses_[k] = poseOf(vectorOf(poses_[k]) + by.segment<3>(static_cast<Eigen::Index>(3 * k)));
  return by.cwiseAbs().maxCoeff();
}

}  // namespace ariadne::loops
