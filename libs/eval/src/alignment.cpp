#include "ariadne/eval/alignment.h"

#include <algorithm>
#include <cmath>

namespace ariadne::eval {

using mrpt::math::TPose2D;

bool poseAt(const geometry::Trajectory& estimate, double time_s, double max_gap_s, TPose2D& pose) {
  const auto after =
      std::lower_bound(estimate.begin(), estimate.end(), time_s,
                       [](const geometry::StampedPose& p, double t) { return p.time_s < t; });
  if (after != estimate.end() && after->time_s == time_s) {
    pose = after->pose;
    return true;
  }
  if (after == estimate.begin() || after == estimate.end()) {
    if (estimate.empty()) return false;
    const auto& end = after == estimate.begin() ? estimate.front() : estimate.back();
    pose = end.pose;
    return std::abs(end.time_s - time_s) <= max_gap_s / 2;
  }
  const auto& a = *(after - 1);
  const auto& b = *after;
  if (b.time_s - a.time_s > max_gap_s) return false;
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  const double turn = std::remainder(b.pose.phi - a.pose.phi, 2 * M_PI);
  pose = {a.pose.x + share * (b.pose.x - a.pose.x), a.pose.y + share * (b.pose.y - a.pose.y),
          a.pose.phi + share * turn};
  return true;
}

std::vector<PosePair> associate(const geometry::Trajectory& estimate,
                                const geometry::Trajectory& truth, double max_gap_s) {
  std::vector<PosePair> pairs;
  for (const auto& t : truth) {
    PosePair pair{t.time_s, {}, t.pose};
    if (poseAt(estimate, t.time_s, max_gap_s, pair.estimate)) pairs.push_back(pair);
  }
  return pairs;
}

TPose2D align(const std::vector<PosePair>& pairs) {
  if (pairs.empty()) return {};
  const auto n = static_cast<double>(pairs.size());
  double ex = 0, ey = 0, tx = 0, ty = 0;
  for (const auto& p : pairs) {
    ex += p.estimate.x / n;
    ey += p.estimate.y / n;
    tx += p.truth.x / n;
    ty += p.truth.y / n;
  }
  double along = 0;
  double across = 0;
  for (const auto& p : pairs) {
    const double ax = p.estimate.x - ex, ay = p.estimate.y - ey;
    const double bx = p.truth.x - tx, by = p.truth.y - ty;
    along += ax * bx + ay * by;
    across += ax * by - ay * bx;
  }
  // One place only: positions tell no rotation, the headings do.
  double turn = std::atan2(across, along);
  if (along == 0 && across == 0)
    turn = std::remainder(pairs[0].truth.phi - pairs[0].estimate.phi, 2 * M_PI);
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  return {tx - (c * ex - s * ey), ty - (s * ex + c * ey), turn};
}

}  // namespace ariadne::eval
