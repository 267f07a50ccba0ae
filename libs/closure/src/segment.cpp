#include "ariadne/closure/segment.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ariadne/models/motion_model.h"

namespace ariadne::closure {
namespace {

using mrpt::math::TPose2D;

constexpr double kKeyframe_m = 1.0;
constexpr double kKeyframe_rad = 0.5;

Eigen::Vector3d vectorOf(const TPose2D& p) { return {p.x, p.y, p.phi}; }
TPose2D poseOf(const Eigen::Vector3d& v) { return {v[0], v[1], std::remainder(v[2], 2 * M_PI)}; }

Eigen::Vector3d gaussians(core::RandomStream& rng) {
  const double a = rng.gaussian(), b = rng.gaussian(), c = rng.gaussian();
  return {a, b, c};
}

/// A relative pose of node b seen from node a; a < 0 is the fixed pose.
struct Factor {
  int a;
  TPose2D fixed;
  int b;
  Eigen::Vector3d measured;
  Eigen::Matrix3d information;
  bool doubted;
};

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

/// The sparse least-squares problem over the keyframes.
class Chain {
 public:
  explicit Chain(std::size_t nodes) : poses_(nodes) {}
  std::vector<TPose2D>& poses() { return poses_; }
  std::vector<Factor>& factors() { return factors_; }

  void optimise(int rounds) {
    for (int round = 0; round < rounds; ++round)
      if (step() < 1e-4) break;
  }
  double cost() const {
    double sum = 0;
    for (const Factor& f : factors_) {
      const Eigen::Vector3d e = linearise(at(f), poses_[index(f.b)], f.measured).error;
      const double chi2 = e.dot(f.information * e);
      sum += f.doubted ? kDoubt * std::log1p(chi2 / kDoubt) : chi2;
    }
    return 0.5 * sum;
  }

 private:
  static constexpr double kDoubt = 9;  // squared Mahalanobis distance from which a tie is doubted
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const TPose2D& at(const Factor& f) const { return f.a < 0 ? f.fixed : poses_[index(f.a)]; }

  double step() {
    const auto n = static_cast<Eigen::Index>(3 * poses_.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(factors_.size() * 36);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
    const auto put = [&](int row, int column, const Eigen::Matrix3d& m) {
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) entries.emplace_back(3 * row + i, 3 * column + k, m(i, k));
    };
    for (const Factor& f : factors_) {
      const Linearised l = linearise(at(f), poses_[index(f.b)], f.measured);
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
    if (!analysed_) solver_.analyzePattern(hessian);
    analysed_ = true;
    solver_.factorize(hessian);
    if (solver_.info() != Eigen::Success)
      throw std::runtime_error("closure: the chain is singular");
    const Eigen::VectorXd by = solver_.solve(gradient);
    for (std::size_t k = 0; k < poses_.size(); ++k)
      poses_[k] = poseOf(vectorOf(poses_[k]) + by.segment<3>(static_cast<Eigen::Index>(3 * k)));
    return by.cwiseAbs().maxCoeff();
  }

  std::vector<TPose2D> poses_;
  std::vector<Factor> factors_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  bool analysed_ = false;
};

/// Updates of the segment that are nodes of the chain; the first is te, the last the last.
std::vector<std::size_t> keyframesOf(const Track& track, std::size_t te) {
  std::vector<std::size_t> keys = {te};
  for (std::size_t k = te + 1; k <= track.now(); ++k) {
    const double turn = std::remainder(track.poses[k].phi - track.poses[keys.back()].phi, 2 * M_PI);
    if (k == track.now() || std::abs(turn) > kKeyframe_rad ||
        track.travelled_m[k] - track.travelled_m[keys.back()] >= kKeyframe_m)
      keys.push_back(k);
  }
  return keys;
}

/// Number of the keyframe at or before the update.
int keyframeAt(const std::vector<std::size_t>& keys, std::size_t update) {
  const auto after = std::upper_bound(keys.begin(), keys.end(), update);
  return static_cast<int>(after - keys.begin()) - 1;
}

Factor factorOf(const Tie& tie, const Track& track, const std::vector<std::size_t>& keys) {
  // Moved rigidly from the tie's updates to their keyframes; te and what is before it stay.
  const int b = keyframeAt(keys, tie.second);
  const std::size_t kb = keys[static_cast<std::size_t>(b)];
  TPose2D measured = models::compose(
      tie.first_from_second, models::relativePose(track.poses[tie.second], track.poses[kb]));
  Factor f{-1, track.poses[tie.first], b - 1, {}, tie.information, tie.doubted};
  if (tie.first > keys.front()) {
    f.a = keyframeAt(keys, tie.first) - 1;
    if (f.a < 0) {
      f.fixed = track.poses[tie.first];
    } else {
      const auto& ka = track.poses[keys[static_cast<std::size_t>(f.a + 1)]];
      const TPose2D key_from_first = models::relativePose(ka, track.poses[tie.first]);
      measured = models::compose(key_from_first, measured);
      // The information turns with the frame; the lever of under a metre is left out.
      Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
      turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(key_from_first.phi).toRotationMatrix();
      f.information = turn * tie.information * turn.transpose();
    }
  }
  f.measured = vectorOf(measured);
  return f;
}

/// Poses of all updates after te, from the keyframes before and after: between two of them the
/// correction grows with the way.
std::vector<TPose2D> spread(const Track& track, const std::vector<std::size_t>& keys,
                            const std::vector<TPose2D>& found) {
  std::vector<TPose2D> out;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const TPose2D from = i == 1 ? track.poses[keys[0]] : found[i - 2];
    const TPose2D& old_from = track.poses[keys[i - 1]];
    const TPose2D moved =
        models::compose(from, models::relativePose(old_from, track.poses[keys[i]]));
    const TPose2D missing = models::relativePose(moved, found[i - 1]);
    const double way = track.travelled_m[keys[i]] - track.travelled_m[keys[i - 1]];
    for (std::size_t k = keys[i - 1] + 1; k <= keys[i]; ++k) {
      const double share =
          k == keys[i]
              ? 1
              : (way > 0 ? (track.travelled_m[k] - track.travelled_m[keys[i - 1]]) / way : 0);
      out.push_back(
          models::compose(models::compose(from, models::relativePose(old_from, track.poses[k])),
                          {share * missing.x, share * missing.y, share * missing.phi}));
    }
  }
  return out;
}

void perturb(std::vector<Factor>& factors, core::RandomStream& rng) {
  for (Factor& f : factors) {
    const Eigen::Matrix3d covariance = f.information.inverse();
    const Eigen::Matrix3d root = covariance.llt().matrixL();
    f.measured += root * gaussians(rng);
  }
}

}  // namespace

Eigen::Matrix3d tieFloor() { return Eigen::Vector3d(0.05 * 0.05, 0.05 * 0.05, 8e-5).asDiagonal(); }

Eigen::Vector3d DriftParams::variances(double way_m, double turned_rad) const {
  const double turn_m = turn_per_sqrt_m_deg * M_PI / 180;
  return {along_per_sqrt_m * along_per_sqrt_m * way_m + 1e-6,
          across_per_sqrt_m * across_per_sqrt_m * way_m + 1e-6,
          turn_m * turn_m * way_m + turn_per_turn * turn_per_turn * turned_rad * turned_rad + 1e-8};
}

std::vector<Tie> tiesOf(const Track& track, const std::vector<Contact>& contacts) {
  std::vector<Tie> ties;
  for (const Contact& c : contacts)
    if (c.second <= track.now())
      ties.push_back({c.first, c.second,
                      models::relativePose(track.poses[c.first], track.poses[c.second]),
                      (c.information.inverse() + tieFloor()).inverse(), true});
  return ties;
}

SegmentSample drawSegment(const Track& track, std::size_t te, const std::vector<Tie>& ties,
                          const DriftParams& drift, core::RandomStream* rng) {
  const std::vector<std::size_t> keys = keyframesOf(track, te);
  if (keys.size() < 2) return {};
  Chain chain(keys.size() - 1);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    chain.poses()[i - 1] = track.poses[keys[i]];
    double turned = 0;
    for (std::size_t k = keys[i - 1] + 1; k <= keys[i]; ++k)
      turned += std::abs(std::remainder(track.poses[k].phi - track.poses[k - 1].phi, 2 * M_PI));
    const Eigen::Vector3d variances =
        drift.variances(track.travelled_m[keys[i]] - track.travelled_m[keys[i - 1]], turned);
    chain.factors().push_back(
        {static_cast<int>(i) - 2, track.poses[te], static_cast<int>(i) - 1,
         vectorOf(models::relativePose(track.poses[keys[i - 1]], track.poses[keys[i]])),
         variances.cwiseInverse().asDiagonal(), false});
  }
  for (const Tie& tie : ties) {
    if (tie.second > track.now() || tie.second < keys[1]) continue;
    Factor f = factorOf(tie, track, keys);
    if (f.a != f.b) chain.factors().push_back(std::move(f));
  }
  SegmentSample out;
  chain.optimise(6);
  out.cost = chain.cost();
  if (rng) {
    perturb(chain.factors(), *rng);
    chain.optimise(3);
  }
  out.poses = spread(track, keys, chain.poses());
  return out;
}

std::vector<Eigen::Matrix3d> driftSinceEach(const Track& track, const DriftParams& drift) {
  std::vector<Eigen::Matrix3d> sums(track.poses.size(), Eigen::Matrix3d::Zero());
  const TPose2D& end = track.poses[track.now()];
  for (std::size_t k = track.now(); k > 0; --k) {
    const TPose2D& a = track.poses[k - 1];
    const TPose2D& b = track.poses[k];
    Eigen::Matrix3d j = Eigen::Matrix3d::Identity();
    j.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(a.phi).toRotationMatrix();
    // A turn in this step swings the end about it.
    j(0, 2) = -(end.y - b.y);
    j(1, 2) = end.x - b.x;
    const Eigen::Vector3d variances =
        drift.variances(track.travelled_m[k] - track.travelled_m[k - 1],
                        std::abs(std::remainder(b.phi - a.phi, 2 * M_PI)));
    sums[k - 1] = sums[k] + j * variances.asDiagonal() * j.transpose();
  }
  return sums;
}

}  // namespace ariadne::closure
