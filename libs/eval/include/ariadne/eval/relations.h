// The relations error: Kuemmerle et al., "On measuring the accuracy of SLAM algorithms", Autonomous
// Robots 27, 2009, Eq. (3)-(5). It needs no alignment: only motions between pairs of moments, which
// somebody verified by hand, are compared.
#pragma once
#include <vector>

#include "ariadne/eval/errors.h"
#include "ariadne/geometry/trajectory.h"

namespace ariadne::eval {

/// Errors of relative poses that were verified by hand (Kümmerle et al., Autonomous Robots 2009).
struct RelationErrors {
  std::vector<double> translation_m;  ///< one a matched relation
  std::vector<double> rotation_deg;
  std::size_t unmatched = 0;  ///< relations for which the trajectory has no pose
};

/// @param max_gap_s as in associate(); 0 takes poses with exactly the relations' stamps only
RelationErrors relationErrors(const geometry::Trajectory& estimate,
                              const std::vector<geometry::Relation>& relations, double max_gap_s);

}  // namespace ariadne::eval
