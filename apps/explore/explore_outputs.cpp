#include "explore_outputs.h"

#include <fmt/format.h>

#include <filesystem>

#include "ariadne/io/dataset_writers.h"
#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "events_json.h"
#include "replay.h"

namespace ariadne::explore_app {
namespace {

namespace fs = std::filesystem;
using slam_app::Material;
using slam_app::Output;

std::string strategyOf(const ExploreConfig& config) {
  return io::nameOf(config.mission.explore.strategy, explore::strategies());
}

void writeDrive(const fs::path& file, const ExplorationResult& result) {
  std::size_t next = 0;
  const auto& steps = result.mission.steps;
  io::writeObservationRawlog(
      file, [&] { return next < steps.size() ? std::optional(steps[next++]) : std::nullopt; });
}

std::size_t followed(const std::vector<explore::Decision>& decisions) {
  std::size_t count = 0;
  for (const auto& d : decisions) count += d.kind == explore::DecisionKind::follow;
  return count;
}

/// What the true loop closures tell; null where there is none.
template <class T>
nlohmann::ordered_json ofLoops(const ExplorationResult& r, T value) {
  if (r.loops == eval::Verdict::no_loop) return nullptr;
  return value;
}

nlohmann::ordered_json explorationOf(const ExplorationResult& r) {
  return {{"world", r.config.world.file},
          {"strategy", strategyOf(r.config)},
          {"end_reason", r.mission.end_reason},
          {"coverage", r.coverage},
          {"ate_rmse_m", r.mapping.truth->ate_rmse_m},
          {"map_score", r.score.f1},
          {"map_precision", r.score.precision},
          {"map_recall", r.score.recall},
          {"map_score_by_grid", r.score_by_grid.f1},
          {"verdict", r.verdict},
          {"correct", ofLoops(r, r.verdict == "correct")},
          {"closures_correct", ofLoops(r, r.loops == eval::Verdict::correct)},
          {"true_closures", r.loop_errors.closures.size()},
          {"worst_closure_error_m", ofLoops(r, r.loop_errors.worst_translation.translation_m)},
          {"worst_closure_error_deg", ofLoops(r, r.loop_errors.worst_heading.heading_deg)},
          {"distance_m", r.mission.distance_m},
          {"duration_s", r.mission.steps.back().time_s},
          {"closings", followed(r.decisions)},
          {"collisions", r.mission.collisions.size()},
          {"decisions", r.decisions.size()},
          {"slowest_decision_ms", 1000 * r.slowest_decision_s},
          {"decisions_s", r.decisions_s}};
}

}  // namespace

std::vector<Output> outputsOf(const ExploreConfig& config, const ExplorationResult& result) {
  std::vector<Output> outputs = {
      {{"drive.rawlog"},
       "the drive: odometry and scans for any SLAM program",
       false,
       [&result](const fs::path& file, const Material&) { writeDrive(file, result); }},
      {{"truth.tum"},
       "where the robot truly was, a pose at every scan",
       false,
       [&result](const fs::path& file, const Material&) {
         io::writeTum(file, result.mission.truth,
                      {"world_from_robot: true poses", "time_s x_m y_m z_m qx qy qz qw"});
       }},
      {{"events.json"},
       "every decision, with its candidates and numbers",
       false,
       [&result](const fs::path& file, const Material&) {
         io::writeWhole(file, eventsJson(result.decisions));
       }}};
  slam_app::SlamConfig mapping;
  mapping.run = config.run;
  mapping.slam = config.mission.slam;
  for (Output& o : slam_app::mappingOutputs(mapping)) outputs.push_back(std::move(o));
  outputs.push_back({{"config.ini"},
                     "all parameters of this run, each explained",
                     false,
                     [&result](const fs::path& file, const Material&) {
                       io::writeWhole(file, io::writeIni(result.config,
                                                         "As resolved for this run. Explores the "
                                                         "same again: ariadne-explore config.ini "
                                                         "--out OTHER"));
                     }});
  outputs.push_back(slam_app::mappingIni("mapping.ini"));
  outputs.back().purpose = "for ariadne-slam, which maps the drive again to the same bits";
  return outputs;
}

std::string summaryText(const ExplorationResult& result, double writing_s,
                        const std::vector<std::string>& files) {
  const auto mapping = slam_app::summaryOf(result.mapping, writing_s, files);
  nlohmann::ordered_json json = {{"program", "ariadne-explore"},
                                 {"versions", mapping.at("versions")},
                                 {"complete", mapping.at("complete")}};
  const auto own = explorationOf(result);
  for (const auto& [key, value] : own.items()) json[key] = value;
  for (const auto& [key, value] : mapping.items())
    if (!json.contains(key)) json[key] = value;
  json["parameters"] = slam_app::parametersJson(result.config);
  return slam_app::jsonText(json);
}

report::Replay replayOf(report::ReplayRecorder& recorder, const slam::Mapper& mapper,
                        const ExplorationResult& result) {
  report::Replay replay = slam_app::replayOf(recorder, mapper, result.mapping);
  replay.title = fmt::format("{}, {}", fs::path(result.config.world.file).filename().string(),
                             strategyOf(result.config));
  const auto fact = [&](const char* name, std::string value) {
    replay.facts.push_back({name, std::move(value)});
  };
  fact("End", result.mission.end_reason);
  fact("Coverage", fmt::format("{:.1f} %", 100 * result.coverage));
  fact("Map score", fmt::format("{:.3f}", result.score.f1));
  fact("Map",
       result.loops == eval::Verdict::no_loop ? "no true loop to judge it by" : result.verdict);
  fact("Collisions", fmt::format("{}", result.mission.collisions.size()));
  return replay;
}

}  // namespace ariadne::explore_app
