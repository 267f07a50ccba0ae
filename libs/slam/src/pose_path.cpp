#include "ariadne/slam/pose_path.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::slam {
namespace {

using mrpt::math::TPose2D;

TPose2D blend(const TPose2D& a, const TPose2D& b, double share) {
  const double turn = std::remainder(b.phi - a.phi, 2 * M_PI);
  return geometry::compose(
      {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.phi + share * turn}, {0, 0, 0});
}

/// Distance and turn as one length, m: a radian counts as a metre, about as between two updates
/// (0.3 m or 15 degrees). By the distance alone, a robot that stops to turn would get the turn's
/// error before it turns.
double motionBetween(const TPose2D& a, const TPose2D& b) {
  return geometry::distance(a, b) + std::abs(std::remainder(b.phi - a.phi, 2 * M_PI));
}

/// Odometry and pose of one filter update.
struct Anchor {
  TPose2D odom;
  TPose2D pose;
  TPose2D follow(const TPose2D& to) const {
    return geometry::compose(pose, geometry::relativePose(odom, to));
  }
};

std::vector<Anchor> anchorsOf(const std::vector<OdometryRecord>& records,
                              const filter::AncestorPtr& leaf) {
  std::vector<Anchor> anchors;
  for (const OdometryRecord& r : records)
    if (r.is_update) anchors.push_back({r.odom_from_robot, {}});
  forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    if (a.step() < anchors.size()) anchors[a.step()].pose = a.pose();
    return true;
  });
  return anchors;
}

}  // namespace

geometry::Trajectory posePath(const std::vector<OdometryRecord>& records,
                              const filter::AncestorPtr& leaf) {
  const std::vector<Anchor> anchors = anchorsOf(records, leaf);
  geometry::Trajectory path;
  path.reserve(records.size());
  for (const OdometryRecord& r : records) {
    TPose2D pose = r.odom_from_robot;
    if (!anchors.empty()) {
      const Anchor& before = anchors[r.updates == 0 ? 0 : r.updates - 1];
      pose = before.follow(r.odom_from_robot);
      if (r.updates > 0 && r.updates < anchors.size() && !r.is_update) {
        const Anchor& after = anchors[r.updates];
        const double done = motionBetween(before.odom, r.odom_from_robot);
        const double left = motionBetween(r.odom_from_robot, after.odom);
        const double share = done + left > 0 ? done / (done + left) : 0;
        pose = blend(pose, after.follow(r.odom_from_robot), share);
      }
    }
    path.push_back({r.time_s, pose});
  }
  return path;
}

}  // namespace ariadne::slam
