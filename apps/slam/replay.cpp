#include "replay.h"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>

#include "ariadne/report/replay_truth.h"
#include "loop_counts.h"
#include "replay_moments.h"

namespace ariadne::slam_app {
namespace {

std::string durationText(const geometry::Trajectory& odometry) {
  const auto s = static_cast<long>(geometry::durationOf(odometry) + 0.5);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02} h", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02} min", s / 60, s % 60);
}

std::vector<report::ReplayFact> factsOf(const RunResult& r) {
  std::vector<report::ReplayFact> facts = {
      {"Scans", fmt::format("{}", r.record.odometry.size())},
      {"Filter updates", fmt::format("{}", r.record.reports.size())},
      {"Duration", durationText(r.record.odometry)},
      {"Path", fmt::format("{:.1f} m", geometry::lengthOf(r.path))},
      {"Particles", fmt::format("{}", r.config.slam.filter.particles)},
      {"Cell", fmt::format("{:g} m", r.config.slam.grid.resolution_m)},
      {"Seed", fmt::format("{}", r.config.slam.filter.seed)}};
  if (r.config.slam.loop_closing.enabled) {
    const LoopCounts n = countLoops(r.closings);
    facts.push_back({"Loops", fmt::format("{} detected, {} closed, {} recovered", n.detected,
                                          n.closed, n.recovered)});
  }
  if (r.truth) facts.push_back({"ATE (RMSE)", fmt::format("{:.3f} m", r.truth->ate_rmse_m)});
  if (r.record.signal != 0) facts.push_back({"Complete", "no, stopped by a signal"});
  return facts;
}

std::vector<std::string> notesOf(const RunResult& r, const report::Replay& replay) {
  std::vector<std::string> notes = {
      fmt::format("Map, path and graph are shown as of {} of the {} updates, particles as of {}.",
                  replay.frames.size(), replay.steps.size(), replay.clouds.size()),
      "The map is that of the best particle s*, Eq. (8), at that moment, and so is the path: both "
      "may jump when another particle becomes the best, or after a recovery.",
      "Map entropy is the sum over the known cells: what is seen for the first time adds to it, "
      "what is "
      "seen again takes from it."};
  if (r.truth)
    notes.push_back(fmt::format(
        "The true path lies where it fits the final path best (rotation and shift, {} poses), as "
        "for the ATE.",
        r.truth->poses));
  notes.push_back("Made by Ariadne " ARIADNE_VERSION ". Charts: Chart.js, MIT licence.");
  return notes;
}

}  // namespace

UpdateListener recordingOf(const SlamConfig& config, const slam::Mapper& mapper,
                           report::ReplayRecorder& recorder) {
  if (!config.run.pictures) return [](const slam::StepReport&) {};
  return [&mapper, &recorder](const slam::StepReport& report) {
    recorder.step(report, report::viewOf(mapper), stateInWords(report));
  };
}

report::Replay replayOf(report::ReplayRecorder& recorder, const slam::Mapper& mapper,
                        const RunResult& result) {
  report::Replay replay = recorder.finish(report::viewOf(mapper));
  replay.title = std::filesystem::path(result.config.dataset.file).filename().string();
  replay.facts = factsOf(result);
  replay.notes = notesOf(result, replay);
  // Before the decisions that they led to: the page keeps the order within an update.
  auto moments = momentsOf(result.closings);
  replay.moments.insert(replay.moments.begin(), std::make_move_iterator(moments.begin()),
                        std::make_move_iterator(moments.end()));
  if (result.truth)
    addTruth(replay, result.truth->truth, result.truth->map_from_truth, kTruthGap_s);
  return replay;
}

}  // namespace ariadne::slam_app
