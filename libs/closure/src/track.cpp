#include "ariadne/closure/track.h"

#include <cmath>

namespace ariadne::closure {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

double distance(const TPose2D& a, const TPose2D& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Track trackOf(const filter::AncestorPtr& leaf,
              const std::vector<Eigen::Matrix3d>& motion_covariance) {
  Track track;
  track.motion_covariance = motion_covariance;
  track.poses.resize(leaf->step() + 1);
  track.motions.resize(leaf->step() + 1);
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    track.poses[a.step()] = a.pose();
    track.motions[a.step()] = a.motion();
    return true;
  });
  double sum = 0;
  for (std::size_t k = 0; k < track.poses.size(); ++k) {
    if (k > 0) sum += distance(track.poses[k], track.poses[k - 1]);
    track.travelled_m.push_back(sum);
  }
  return track;
}

TPoint2D placed(const TPose2D& pose, const TPoint2D& p) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  return {pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y};
}

std::vector<TPoint2D> placed(const TPose2D& pose, const std::vector<TPoint2D>& points) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  std::vector<TPoint2D> out;
  out.reserve(points.size());
  for (const TPoint2D& p : points)
    out.emplace_back(pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y);
  return out;
}

}  // namespace ariadne::closure
