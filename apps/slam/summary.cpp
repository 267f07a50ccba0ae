#include "summary.h"

#include <mrpt/system/os.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "ariadne/core/parallel.h"
#include "ariadne/geometry/trajectory.h"
#include "loop_counts.h"

namespace ariadne::slam_app {
namespace {

using Json = nlohmann::ordered_json;

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

Json filterFigures(const std::vector<slam::StepReport>& reports) {
  double neff_sum = 0;
  double neff_min = reports.empty() ? 0 : reports.front().neff;
  std::size_t resamplings = 0;
  std::size_t accepted = 0;
  std::size_t tried = 0;
  for (const slam::StepReport& r : reports) {
    neff_sum += r.neff;
    neff_min = std::min(neff_min, r.neff);
    resamplings += r.resampled ? 1 : 0;
    if (r.step == 0) continue;  // the first scan has no map to be matched with
    accepted += r.matches_accepted;
    tried += r.particles;
  }
  const auto share = [](double a, double b) { return b > 0 ? a / b : 0; };
  return {
      {"updates", reports.size()},
      {"resamplings", resamplings},
      {"neff_mean", share(neff_sum, static_cast<double>(reports.size()))},
      {"neff_min", neff_min},
      {"matches_accepted_share", share(static_cast<double>(accepted), static_cast<double>(tried))}};
}

/// Each check's figure; what is out of bounds is told in the warnings.
Json checkFigures(const RunResult& r) {
  Json out;
  for (const checks::Check& check : r.checks) out[check.name] = check.value;
  out["odometry_jumps"] = {{"count", r.counts.odometry_jumps.count},
                           {"told_by_scan", r.doubts.jumps_by_scan},
                           {"told_by_odometry", r.doubts.jumps_by_odometry},
                           {"guessed", r.doubts.jumps_guessed}};
  out["clock_set_back"] = r.counts.scan_clock.count;
  return out;
}

/// Shares of [motion] that the log's own matches support, and its constant turn.
Json learnedMotion(const models::MotionLearner& learned, const models::MotionParams& wide) {
  if (!wide.learn) return {};
  const auto [along, across, turn] = learned.scales();
  return {{"steps", learned.steps()},
          {"along_scale", along},
          {"across_scale", across},
          {"turn_scale", turn},
          {"turn_deg_per_m", learned.turnPerMetre() * 180 / M_PI},
          {"stretch_m_per_m", learned.stretch()}};
}

Json loopFigures(const std::vector<loops::ClosingRecord>& closings, std::size_t found) {
  const LoopCounts n = countLoops(closings);
  return {{"detected", n.detected},
          {"closed", n.closed},
          {"recovered", n.recovered},
          {"found_from_afar", found}};
}

Json datasetFigures(const RunResult& r) {
  const geometry::Trajectory& odometry = r.record.odometry;
  const io::DatasetCounts& c = r.counts;
  return {{"file", r.config.dataset.file},
          {"laser", r.laser_label},
          {"scans", odometry.size()},
          {"duration_s", geometry::durationOf(odometry)},
          {"odometry_length_m", r.record.drive.odometry_m},
          {"beams", c.beams},
          {"beams_no_return", c.beams_no_return},
          {"no_return_from_m", c.no_return_from_m > 0 ? Json(c.no_return_from_m) : Json()},
          {"beams_over_reach", c.beams_over_reach},
          {"beams_too_near", c.beams_too_near},
          {"beams_bad", c.beams_out_of_range + c.beams_nan + c.beams_zero + c.beams_negative +
                            c.beams_too_near + c.beams_flagged}};
}

/// The map that was gone on with; null for a new one.
Json continuedFrom(const Continuation& from) {
  if (from.map_file.empty()) return {};
  return {{"map", from.map_file},
          {"scans", from.scans},
          {"start_m_rad", {from.start.x, from.start.y, from.start.phi}},
          {"searched", from.searched},
          {"field", from.field}};
}

/// Wall clock by stage, CPU and memory of the process.
Json costs(const RunResult& r, double writing_s) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double user_s = seconds(usage.ru_utime);
  const double system_s = seconds(usage.ru_stime);
  const double mapping_s = r.record.total_s;
  return {{"wall_s",
           {{"reading", r.record.reading_s},
            {"predict_match_weigh_resample", r.stages.predict_s},
            {"insert", r.stages.insert_s},
            {"loops", r.stages.loops_s},
            {"recording", r.record.recording_s},
            {"reading_and_mapping", mapping_s},
            {"writing", writing_s}}},
          {"scans_per_s",
           mapping_s > 0 ? static_cast<double>(r.record.odometry.size()) / mapping_s : 0},
          {"cpu_user_s", user_s},
          {"cpu_system_s", system_s},
          {"cpu_s", user_s + system_s},
          {"peak_memory_mb", static_cast<double>(usage.ru_maxrss) / 1024}};
}

}  // namespace

Json summaryOf(const RunResult& result, double writing_s, const std::vector<std::string>& files) {
  return {{"program", "ariadne-slam"},
          {"versions", {{"ariadne", ARIADNE_VERSION}, {"mrpt", mrpt::system::MRPT_getVersion()}}},
          {"complete", result.record.signal == 0},
          {"seed", result.config.slam.filter.seed},
          {"threads", core::Parallel(result.config.run.threads).threads()},
          {"dataset", datasetFigures(result)},
          {"continued", continuedFrom(result.from)},
          {"filter", filterFigures(result.record.reports)},
          {"loops", loopFigures(result.closings, result.found.size())},
          {"learned_motion", learnedMotion(result.learned, result.config.slam.motion)},
          {"path_length_m", geometry::lengthOf(result.path)},
          {"checks", checkFigures(result)},
          {"ate_rmse_m", result.truth ? Json(result.truth->ate_rmse_m) : Json()},
          {"costs", costs(result, writing_s)},
          {"warnings", result.warnings},
          {"files", files},
          {"parameters", parametersJson(result.config)}};
}

std::string jsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ariadne::slam_app
