// The true path, where somebody knows it, into a replay.
#pragma once
#include "ariadne/geometry/trajectory.h"
#include "ariadne/report/replay.h"

namespace ariadne::report {

/// Gives each step that has a true pose that pose and its error.
/// @param truth truth_from_robot, in time order
/// @param map_from_truth where the truth's frame lies: known (a simulation), or by alignment
/// @param max_gap_s as in eval::associate()
void addTruth(Replay& replay, const geometry::Trajectory& truth,
              const mrpt::math::TPose2D& map_from_truth, double max_gap_s);

}  // namespace ariadne::report
