// Whether an arm of a run came out right.
#pragma once
#include "ariadne/experiment/loop_run.h"
#include "ariadne/geometry/trajectory.h"
#include "ariadne/slam/mapper.h"

namespace ariadne::experiment {

/// @param truth world_from_robot at every step that the mapper processed
ArmResult armResultOf(const slam::Mapper& mapper, const geometry::Trajectory& truth,
                      const eval::CorrectBounds& bounds);

}  // namespace ariadne::experiment
