#include "ariadne/report/replay_truth.h"

#include <cmath>

#include "ariadne/eval/alignment.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::report {

void addTruth(Replay& replay, const geometry::Trajectory& truth,
              const mrpt::math::TPose2D& map_from_truth, double max_gap_s) {
  for (ReplayStep& step : replay.steps) {
    mrpt::math::TPose2D truth_from_robot;
    if (!eval::poseAt(truth, step.time_s, max_gap_s, truth_from_robot)) continue;
    step.truth = geometry::compose(map_from_truth, truth_from_robot);
    step.error_m = geometry::distance(*step.truth, step.map_from_robot);
  }
}

}  // namespace ariadne::report
