// What is told of a set of hypotheses: its lines, its weighted poses, their spread.
#pragma once
#include <vector>

#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/weighted_poses.h"
#include "ariadne/loops/closing/closing_record.h"
#include "ariadne/loops/recovery/saved_set.h"

namespace ariadne::loops {

std::vector<filter::AncestorPtr> leavesOf(const filter::ParticleSet& particles);
/// As of te.
geometry::WeightedPoses posesOf(const SavedSet& saved);
/// Root of the trace of the weighted covariance of the positions, m.
double spreadOf(const geometry::WeightedPoses& set);

}  // namespace ariadne::loops
