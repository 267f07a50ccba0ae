// The effective number of particles, Eq. (10).
#pragma once
#include <vector>

#include "ariadne/geometry/weighted_poses.h"

namespace ariadne::eval {

/// Neff = 1 / sum of w^2, from 1 (one particle has it all) to N (all weigh the same).
/// @param weights normalised; core::Error when they are not, see geometry::checkWeights()
double neff(const std::vector<double>& weights);

}  // namespace ariadne::eval
