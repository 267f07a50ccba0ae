#include "exploration.h"

#include <fmt/format.h>

#include <chrono>

#include "ariadne/geometry/pose.h"
#include "ariadne/mission/coverage.h"
#include "ariadne/sim/walls.h"
#include "decision_moments.h"

namespace ariadne::explore_app {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const grid::OccupancyGrid& mapOf(const slam::Mapper& mapper) {
  return mapper.particles()[mapper.particles().best()].map;
}

double freeArea(const grid::OccupancyGrid& map) {
  std::size_t cells = 0;
  map.cells().forEachTile([&](int, int, const auto& tile) {
    for (const std::int8_t odds : tile) cells += odds > 0;
  });
  return static_cast<double>(cells) * map.resolution() * map.resolution();
}

std::string progressLine(const mission::Mission& mission, const slam::StepReport& report,
                         double time_s) {
  return fmt::format("{:.0f} m2  {:.0f} m  {:.0f} s driven  Neff {:.1f} of {}  {}",
                     freeArea(mapOf(mission.mapper())), mission.explorer().travelled_m(), time_s,
                     report.neff, report.particles, mission.explorer().doing());
}

/// Decisions become moments of the report, each at the update after which it was made.
class Recording {
 public:
  Recording(const slam::Mapper& mapper, report::ReplayRecorder& recorder)
      : mapper_(mapper), recorder_(recorder) {}

  void update(const slam::StepReport& report, const explore::Explorer& explorer) {
    markDecisions(explorer);
    recorder_.show(sceneOf(explorer, mapper_));
    recorder_.step(report, report::viewOf(mapper_), explorer.doing());
  }
  /// Those that are new; the last one may come after the last update.
  void markDecisions(const explore::Explorer& explorer) {
    const auto& decisions = explorer.decisions();
    for (; told_ < decisions.size(); ++told_) recorder_.mark(momentOf(decisions[told_]));
  }

 private:
  const slam::Mapper& mapper_;
  report::ReplayRecorder& recorder_;
  std::size_t told_ = 0;
};

slam_app::MappingRecord recordOf(const mission::MissionRecord& mission) {
  slam_app::MappingRecord record;
  record.reports = mission.reports;
  for (const auto& step : mission.steps)
    record.odometry.push_back({step.time_s, step.odom_from_robot});
  return record;
}

io::DatasetCounts countsOf(const mission::MissionRecord& mission) {
  io::DatasetCounts counts;
  for (const auto& step : mission.steps) {
    ++counts.steps;
    counts.beams += step.scan->getScanSize();
    for (std::size_t i = 0; i < step.scan->getScanSize(); ++i)
      counts.beams_no_return += !step.scan->getScanRangeValidity(i);
  }
  return counts;
}

}  // namespace

ExplorationResult carryOut(mission::Mission& mission, const ExploreConfig& config,
                           const app::Interrupt& interrupt, app::Progress& progress,
                           report::ReplayRecorder& recorder) {
  const Clock::time_point start = Clock::now();
  Recording recording(mission.mapper(), recorder);
  ExplorationResult result;
  result.config = config;
  double recording_s = 0;
  result.mission = mission.run([&](const slam::StepReport& report, const auto& explorer) {
    if (config.run.pictures) {
      const Clock::time_point before = Clock::now();
      recording.update(report, explorer);
      recording_s += secondsSince(before);
    }
    if (progress.due()) progress.show(progressLine(mission, report, report.time_s));
    return interrupt.signal() == 0;
  });
  if (config.run.pictures) recording.markDecisions(mission.explorer());
  progress.finish();
  slam_app::RunResult& mapping = result.mapping;
  mapping.record = recordOf(result.mission);
  mapping.record.recording_s = recording_s;
  mapping.record.total_s = secondsSince(start);
  mapping.record.signal = interrupt.signal();
  mapping.config.run = config.run;
  mapping.config.slam = config.mission.slam;
  mapping.stages = mission.mapper().times();
  mapping.closings = mission.mapper().closings();
  mapping.path = mission.mapper().path();
  mapping.counts = countsOf(result.mission);
  mapping.laser_label = result.mission.steps.front().scan->sensorLabel;
  result.decisions = mission.explorer().decisions();
  result.slowest_decision_s = mission.explorer().slowestDecision_s();
  result.decisions_s = mission.explorer().decisions_s();
  return result;
}

void measure(ExplorationResult& result, const mission::Mission& mission, const sim::World& world,
             const mrpt::math::TPose2D& start) {
  const auto& params = result.config.mission;
  const double resolution_m = params.slam.grid.resolution_m;
  const auto truth = mission::seeable(world, start, params.sim.drive, resolution_m);
  result.coverage = mission::coverage(
      world, truth, mission::sighted(result.mission.steps, result.mission.truth, resolution_m));
  slam_app::RunResult& mapping = result.mapping;
  mapping.truth = slam_app::fitTruth(mapping.path, result.mission.truth);
  const auto truth_from_map = geometry::relativePose(mapping.truth->map_from_truth, {0, 0, 0});
  const double tolerance_m = result.config.map_score.tolerance_m;
  const auto walls = eval::wallsOf(mapOf(mission.mapper()));
  const auto scoreAgainst = [&](const std::vector<mrpt::math::TPoint2D>& true_walls,
                                double cell_m) {
    return eval::mapScore(walls, true_walls, truth_from_map, tolerance_m, cell_m);
  };
  result.score = scoreAgainst(sim::wallsHit(world, result.mission.truth, params.sim.drive),
                              world.map.getResolution());
  result.score_by_grid = scoreAgainst(eval::wallsOf(truth), resolution_m);
  result.loop_errors = eval::loopErrors(mapping.path, result.mission.truth, 0);
  result.loops = eval::verdictOf(result.loop_errors, result.config.correct);
  const bool bent = result.loops == eval::Verdict::correct &&
                    result.score.f1 < result.config.map_score.right_from;
  result.verdict = bent ? "bent" : eval::nameOf(result.loops);
}

}  // namespace ariadne::explore_app
