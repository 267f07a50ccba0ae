#include "ariadne/experiment/loop_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ariadne/eval/kl_divergence.h"
#include "ariadne/experiment/mapper_arms.h"
#include "ariadne/experiment/neff_fall.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/loops/closing/stop_rules.h"
#include "arm_result.h"

namespace ariadne::experiment {
namespace {

using mrpt::math::TPose2D;

/// Distance between where the pose is and where it truly was, both seen from the start.
double errorAt(const TPose2D& pose, const TPose2D& start, const TPose2D& true_from_start) {
  const TPose2D moved = geometry::relativePose(start, pose);
  return geometry::distance(moved, true_from_start);
}

double leastError(const std::vector<TPose2D>& poses, const TPose2D& start,
                  const TPose2D& true_from_start) {
  double least = std::numeric_limits<double>::infinity();
  for (const TPose2D& p : poses) least = std::min(least, errorAt(p, start, true_from_start));
  return least;
}

InnerLoop innerOf(const loops::ClosingRecord& record, const TPose2D& start,
                  const TPose2D& true_from_start) {
  const loops::SavingRecord& saving = *record.saving;
  const loops::RecoveryRecord& recovery = *record.recovery;
  const std::size_t te = record.closing.opportunity.te;
  geometry::WeightedPoses left;
  for (const auto& leaf : recovery.before)
    left.poses.push_back(filter::ancestorAt(leaf, te)->pose());
  left.weights = recovery.weights_before;

  InnerLoop inner;
  inner.existed_error_m = leastError(saving.at_te.poses, start, true_from_start);
  inner.saved_error_m = leastError(saving.saved.poses, start, true_from_start);
  inner.left_error_m = leastError(left.poses, start, true_from_start);
  inner.survivors = static_cast<double>(saving.distinct_ancestors) /
                    static_cast<double>(std::max<std::size_t>(saving.existed, 1));
  inner.distinct_left = recovery.distinct_before;
  inner.distinct_saved = recovery.distinct_after;
  const eval::Divergence saved = eval::divergence(saving.at_te, saving.saved);
  inner.kl_saved_nats = saved.kl_nats;
  inner.lost_mass = saved.lost_mass;
  inner.kl_left_nats = eval::divergence(saving.at_te, left).kl_nats;
  const auto& steps = record.closing.course.steps;
  inner.neff_slope_per_m = loops::slopeOfLogNeff(steps, 0);
  inner.resamplings = static_cast<double>(
      std::count_if(steps.begin(), steps.end(), [](const auto& s) { return s.resampled; }));
  inner.recovery_s = recovery.seconds;
  return inner;
}

/// @param updates up to the recovery
void addNeff(InnerLoop& inner, const std::vector<NeffStep>& updates,
             const geometry::Trajectory& truth) {
  const auto falls = neffFall(neffChanges(updates, eval::pathPasses(truth)));
  double* const figures[] = {&inner.ln_neff_new_per_10m, &inner.ln_neff_once_per_10m,
                             &inner.ln_neff_twice_per_10m, &inner.ln_neff_more_per_10m};
  for (std::size_t i = 0; i < falls.size(); ++i)
    if (falls[i].travelled_m > 0) *figures[i] = 10 * falls[i].ln_change / falls[i].travelled_m;
}

/// The inner loop is the first one that was recovered.
std::optional<InnerLoop> innerOf(const slam::Mapper& mapper, const geometry::Trajectory& truth,
                                 std::vector<NeffStep> updates) {
  for (const loops::ClosingRecord& record : mapper.closings()) {
    if (!record.recovery) continue;
    const double time = updates[record.closing.opportunity.te].time_s;
    const auto at =
        std::lower_bound(truth.begin(), truth.end(), time,
                         [](const geometry::StampedPose& p, double t) { return p.time_s < t; });
    InnerLoop inner = innerOf(record, mapper.path().front().pose,
                              geometry::relativePose(truth.front().pose, at->pose));
    updates.resize(record.recovery->update + 1);
    addNeff(inner, updates, truth);
    return inner;
  }
  return std::nullopt;
}

}  // namespace

LoopRunResult runLoop(const sim::SimulatedDrive& seen, const slam::SlamParams& params,
                      const eval::CorrectBounds& bounds, std::uint64_t seed) {
  slam::SlamParams seeded = params;
  seeded.filter.seed = seed;
  slam::Mapper mapper(seeded, 1);
  std::unique_ptr<slam::Mapper> standard;
  MapperArms::beforeRecovery(mapper, [&] {
    if (!standard) standard = MapperArms::forkWithoutRecovery(mapper);
  });
  std::vector<NeffStep> updates;
  for (const models::SensorStep& step : seen.steps) {
    if (standard) standard->process(step);
    if (const auto report = mapper.process(step))
      updates.push_back(
          {step.time_s, report->neff, report->resampled, static_cast<double>(report->particles)});
  }
  LoopRunResult result;
  result.recovered = armResultOf(mapper, seen.truth, bounds);
  result.standard = standard ? armResultOf(*standard, seen.truth, bounds) : result.recovered;
  result.inner = innerOf(mapper, seen.truth, std::move(updates));
  for (const loops::ClosingRecord& record : mapper.closings()) {
    ++result.closings;
    result.recoveries += record.recovery ? 1 : 0;
  }
  return result;
}

}  // namespace ariadne::experiment
