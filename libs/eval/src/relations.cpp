#include "ariadne/eval/relations.h"

#include <cmath>

#include "ariadne/models/motion_model.h"

namespace ariadne::eval {

RelationErrors relationErrors(const models::Trajectory& estimate,
                              const std::vector<models::Relation>& relations, double max_gap_s) {
  RelationErrors errors;
  for (const models::Relation& r : relations) {
    mrpt::math::TPose2D a;
    mrpt::math::TPose2D b;
    if (!poseAt(estimate, r.time1_s, max_gap_s, a) || !poseAt(estimate, r.time2_s, max_gap_s, b)) {
      ++errors.unmatched;
      continue;
    }
    const auto error = models::relativePose(r.motion, models::relativePose(a, b));
    errors.translation_m.push_back(std::hypot(error.x, error.y));
    errors.rotation_deg.push_back(std::abs(error.phi) * 180 / M_PI);
  }
  return errors;
}

}  // namespace ariadne::eval
