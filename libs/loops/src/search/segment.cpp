#include "ariadne/loops/search/segment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ariadne/geometry/covariance.h"
#include "ariadne/geometry/pose.h"
#include "chain.h"

namespace ariadne::loops {
namespace {

using mrpt::math::TPose2D;

constexpr double kKeyframe_m = 1.0;
constexpr double kKeyframe_rad = 0.5;

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

struct MeasuredMotion {
  TPose2D mean;
  Eigen::Matrix3d covariance;
};

/// The motion from one update to a later one as it was measured, in the frame of the first. A
/// little is left to motions that cannot be wrong, so that the chain is never singular.
MeasuredMotion motionBetween(const Track& track, std::size_t from, std::size_t to) {
  MeasuredMotion sum{{}, Eigen::Vector3d(1e-6, 1e-6, 1e-8).asDiagonal()};
  for (std::size_t k = from + 1; k <= to; ++k) {
    sum.covariance = geometry::composedCovariance(sum.mean, sum.covariance, track.motions[k],
                                                  track.motion_covariance[k]);
    sum.mean = geometry::compose(sum.mean, track.motions[k]);
  }
  return sum;
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
  TPose2D measured = geometry::compose(
      tie.first_from_second, geometry::relativePose(track.poses[tie.second], track.poses[kb]));
  Factor f{-1, track.poses[tie.first], b - 1, {}, tie.information, tie.doubted};
  if (tie.first > keys.front()) {
    f.a = keyframeAt(keys, tie.first) - 1;
    if (f.a < 0) {
      f.fixed = track.poses[tie.first];
    } else {
      const auto& ka = track.poses[keys[static_cast<std::size_t>(f.a + 1)]];
      const TPose2D key_from_first = geometry::relativePose(ka, track.poses[tie.first]);
      measured = geometry::compose(key_from_first, measured);
      // The information turns with the frame; the lever of under a metre is left out.
      const Eigen::Matrix3d turn = geometry::turnedBy(key_from_first.phi);
      f.information = turn * tie.information * turn.transpose();
    }
  }
  f.measured = vectorOf(measured);
  return f;
}

/// Poses of all updates after te, from the keyframes before and after: between two of them the
/// correction grows with the path.
std::vector<TPose2D> spread(const Track& track, const std::vector<std::size_t>& keys,
                            const std::vector<TPose2D>& found) {
  std::vector<TPose2D> out;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const TPose2D from = i == 1 ? track.poses[keys[0]] : found[i - 2];
    const TPose2D& old_from = track.poses[keys[i - 1]];
    const TPose2D moved =
        geometry::compose(from, geometry::relativePose(old_from, track.poses[keys[i]]));
    const TPose2D missing = geometry::relativePose(moved, found[i - 1]);
    const double path_m = track.travelled_m[keys[i]] - track.travelled_m[keys[i - 1]];
    for (std::size_t k = keys[i - 1] + 1; k <= keys[i]; ++k) {
      const double share =
          k == keys[i]
              ? 1
              : (path_m > 0 ? (track.travelled_m[k] - track.travelled_m[keys[i - 1]]) / path_m : 0);
      out.push_back(geometry::compose(
          geometry::compose(from, geometry::relativePose(old_from, track.poses[k])),
          {share * missing.x, share * missing.y, share * missing.phi}));
    }
  }
  return out;
}

}  // namespace

Eigen::Matrix3d tieFloor() { return Eigen::Vector3d(0.05 * 0.05, 0.05 * 0.05, 8e-5).asDiagonal(); }

std::vector<Tie> tiesOf(const Track& track, const std::vector<Contact>& contacts) {
  std::vector<Tie> ties;
  for (const Contact& c : contacts)
    if (c.second <= track.now())
      ties.push_back({c.first, c.second,
                      c.first_from_second
                          ? *c.first_from_second
                          : geometry::relativePose(track.poses[c.first], track.poses[c.second]),
                      (c.information.inverse() + tieFloor()).inverse(), true});
  return ties;
}

namespace {

void addMotions(const Track& track, const std::vector<std::size_t>& keys, Chain& chain) {
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const auto node = static_cast<int>(i) - 1;
    const MeasuredMotion motion = motionBetween(track, keys[i - 1], keys[i]);
    chain.poses()[i - 1] = track.poses[keys[i]];
    chain.factors().push_back({node - 1, track.poses[keys.front()], node, vectorOf(motion.mean),
                               motion.covariance.inverse(), false});
  }
}

}  // namespace

SegmentSample drawSegment(const Track& track, std::size_t te, const std::vector<Tie>& ties,
                          core::RandomStream* rng) {
  const std::vector<std::size_t> keys = keyframesOf(track, te);
  if (keys.size() < 2) return {};
  Chain chain(keys.size() - 1);
  addMotions(track, keys, chain);
  const auto add = [&](bool doubted) {
    for (const Tie& tie : ties) {
      if (tie.doubted != doubted || tie.second > track.now() || tie.second < keys[1]) continue;
      Factor f = factorOf(tie, track, keys);
      if (f.a != f.b) chain.factors().push_back(std::move(f));
    }
  };
  SegmentSample out;
  add(true);
  chain.optimise(6);
  out.cost = -chain.cost();
  add(false);
  chain.optimise(6);
  out.cost += chain.cost();
  if (rng) {
    chain.perturb(*rng);
    chain.optimise(3);
  }
  out.poses = spread(track, keys, chain.poses());
  return out;
}

std::vector<Eigen::Matrix3d> driftSinceEach(const Track& track) {
  std::vector<Eigen::Matrix3d> sums(track.poses.size(), Eigen::Matrix3d::Zero());
  const TPose2D& end = track.poses[track.now()];
  for (std::size_t k = track.now(); k > 0; --k) {
    const TPose2D& a = track.poses[k - 1];
    const TPose2D& b = track.poses[k];
    Eigen::Matrix3d j = geometry::turnedBy(a.phi);
    // A turn in this step swings the end about it.
    j(0, 2) = -(end.y - b.y);
    j(1, 2) = end.x - b.x;
    sums[k - 1] = sums[k] + j * track.motion_covariance[k] * j.transpose();
  }
  return sums;
}

}  // namespace ariadne::loops
