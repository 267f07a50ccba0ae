#include "ariadne/loops/search/track.h"

#include "ariadne/geometry/pose.h"

namespace ariadne::loops {

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
    if (k > 0) sum += geometry::distance(track.poses[k], track.poses[k - 1]);
    track.travelled_m.push_back(sum);
  }
  return track;
}

}  // namespace ariadne::loops
