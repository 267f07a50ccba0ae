#include "ariadne/report/replay_truth.h"

#include <cmath>

#include "ariadne/eval/alignment.h"
#include "ariadne/models/motion_model.h"

namespace ariadne::report {

void addTruth(Replay& replay, const models::Trajectory& truth,
              const mrpt::math::TPose2D& map_from_truth, double max_gap_s) {
  for (ReplayStep& step : replay.steps) {
    mrpt::math::TPose2D truth_from_robot;
    if (!eval::poseAt(truth, step.time_s, max_gap_s, truth_from_robot)) continue;
    step.truth = models::compose(map_from_truth, truth_from_robot);
    step.error_m =
        std::hypot(step.truth->x - step.map_from_robot.x, step.truth->y - step.map_from_robot.y);
  }
}

}  // namespace ariadne::report
