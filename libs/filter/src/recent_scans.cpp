#include "ariadne/filter/recent_scans.h"

#include <cmath>

namespace ariadne::filter {
namespace {

constexpr double kLength_m = 10;

}  // namespace

double sigmasOff(const mrpt::math::TPose2D& pose, const models::PosePrior& prior) {
  const Eigen::Vector3d d(pose.x - prior.mean.x, pose.y - prior.mean.y,
                          std::remainder(pose.phi - prior.mean.phi, 2 * M_PI));
  return std::sqrt(d.dot(prior.covariance.ldlt().solve(d)));
}

void RecentScans::add(std::size_t step, const grid::ScanShape& shape, double travelled_m) {
  if (sigmas_ == 0) return;
  scans_.push_back({step, shape, travelled_m});
  length_m_ += travelled_m;
  while (length_m_ > kLength_m) {
    length_m_ -= scans_.front().travelled_m;
    scans_.pop_front();
  }
}

bool RecentScans::dispute(const models::Match& match, const models::PosePrior& prior) const {
  return sigmas_ > 0 && match.accepted && sigmasOff(match.map_from_robot, prior) > sigmas_;
}

models::Match RecentScans::matched(const models::PosePrior& prior,
                                   const models::ScanMatcher& matcher,
                                   const std::vector<mrpt::math::TPoint2D>& points,
                                   const AncestorPtr& leaf) const {
  return matcher(mapAlong(leaf), points, prior.mean, prior.covariance);
}

models::Match RecentScans::settled(const models::Match& match, const models::Match& recent,
                                   const models::PosePrior& prior) {
  const bool other =
      sigmasOff(recent.map_from_robot, prior) < sigmasOff(match.map_from_robot, prior) / 2;
  return other && recent.score > match.score ? recent : match;
}

grid::OccupancyGrid RecentScans::mapAlong(const AncestorPtr& leaf) const {
  std::vector<grid::PlacedScan> placed;
  auto scan = scans_.rbegin();
  forEachAncestor(leaf, [&](const Ancestor& a) {
    if (scan == scans_.rend()) return false;
    placed.push_back({&scan->shape, a.pose()});
    ++scan;
    return true;
  });
  grid::OccupancyGrid map(grid_);
  map.insertMany(placed);
  return map;
}

}  // namespace ariadne::filter
