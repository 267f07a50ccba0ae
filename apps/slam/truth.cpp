#include "truth.h"

#include "ariadne/eval/alignment.h"
#include "ariadne/eval/errors.h"
#include "ariadne/models/motion_model.h"

namespace ariadne::slam_app {

std::optional<TruthFit> fitTruth(const models::Trajectory& path, models::Trajectory truth) {
  const auto pairs = eval::associate(models::sortedByTime(path), truth, kTruthGap_s);
  if (pairs.empty()) return std::nullopt;
  TruthFit fit;
  const auto truth_from_map = eval::align(pairs);
  fit.map_from_truth = models::relativePose(truth_from_map, {0, 0, 0});
  fit.ate_rmse_m = eval::figuresOf(eval::absoluteErrors(pairs, truth_from_map)).rmse;
  fit.poses = pairs.size();
  fit.truth = std::move(truth);
  return fit;
}

}  // namespace ariadne::slam_app
