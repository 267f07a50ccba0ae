#include "ariadne/eval/relations.h"

#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::eval {

RelationErrors relationErrors(const geometry::Trajectory& estimate,
                              const std::vector<geometry::Relation>& relations, double max_gap_s) {
  RelationErrors errors;
  for (const geometry::Relation& r : relations) {
    mrpt::math::TPose2D a;
    mrpt::math::TPose2D b;
    if (!poseAt(estimate, r.time1_s, max_gap_s, a) || !poseAt(estimate, r.time2_s, max_gap_s, b)) {
      ++errors.unmatched;
      continue;
    }
    const auto error = geometry::relativePose(r.motion, geometry::relativePose(a, b));
    errors.translation_m.push_back(std::hypot(error.x, error.y));
    errors.rotation_deg.push_back(std::abs(error.phi) * 180 / M_PI);
  }
  return errors;
}

}  // namespace ariadne::eval
