#include "truth.h"

#include "ariadne/eval/alignment.h"
#include "ariadne/eval/errors.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::slam_app {

std::optional<TruthFit> fitTruth(const geometry::Trajectory& path, geometry::Trajectory truth) {
  const auto pairs = eval::associate(geometry::sortedByTime(path), truth, kTruthGap_s);
  if (pairs.empty()) return std::nullopt;
  TruthFit fit;
  const auto truth_from_map = eval::align(pairs);
  fit.map_from_truth = geometry::relativePose(truth_from_map, {0, 0, 0});
  fit.ate_rmse_m = eval::figuresOf(eval::absoluteErrors(pairs, truth_from_map)).rmse;
  fit.poses = pairs.size();
  fit.truth = std::move(truth);
  return fit;
}

}  // namespace ariadne::slam_app
