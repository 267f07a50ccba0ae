#include "run_checks.h"

#include <fmt/format.h>

#include "ariadne/checks/checks.h"

namespace ariadne::slam_app {
namespace {

/// How the steps went on that the odometry does not tell.
std::vector<std::string> doubtWarnings(const RunResult& r) {
  std::vector<std::string> warnings;
  const slam::DoubtCounts& d = r.doubts;
  if (d.jumps_by_scan + d.jumps_by_odometry + d.jumps_guessed > 0)
    warnings.push_back(fmt::format(
        "where the odometry jumped: {} times the scan told where the robot was, {} times it fitted "
        "where the odometry jumped to, {} times it fitted neither and the robot was taken to be "
        "where it lies better",
        d.jumps_by_scan, d.jumps_by_odometry, d.jumps_guessed));
  if (r.record.scans_lost > 0)
    warnings.push_back(fmt::format(
        "{} of {} scans fitted nowhere about the ones before: there the odometry made of the scans "
        "is a guess",
        r.record.scans_lost, r.record.odometry.size()));
  return warnings;
}

}  // namespace

void checkRun(RunResult& result) {
  checks::MapFigures map;
  map.updates = result.record.reports.size();
  map.path_m = geometry::lengthOf(result.path);
  for (const slam::StepReport& r : result.record.reports) {
    // The first scan has no map to be matched with.
    if (r.step == 0 || result.config.slam.filter.proposal == filter::Proposal::odometry) continue;
    map.matches_accepted += r.matches_accepted;
    map.matches_tried += r.particles;
  }
  const io::DatasetCounts& c = result.counts;
  result.checks = checks::checkLog(result.record.drive,
                                   c.scans_backwards + c.scans_not_planar + c.scans_malformed);
  for (checks::Check& check : checks::checkMap(result.record.drive, map))
    result.checks.push_back(std::move(check));
  for (std::string& w : checks::warningsOf(result.checks)) result.warnings.push_back(std::move(w));
  for (std::string& w : doubtWarnings(result)) result.warnings.push_back(std::move(w));
}

core::Error nothingMapped(const SlamConfig& config, const MappingRecord& record,
                          const slam::Mapper& mapper) {
  std::string why = "no scan that can be used";
  if (record.signal != 0)
    why = "stopped before the first scan";
  else if (mapper.doubts().blind_scans > 0)
    why = fmt::format(
        "in each of its {} scans hardly a beam returned within [grid] insert_range_m ([update] "
        "least_returns)",
        mapper.doubts().blind_scans);
  return core::Error(fmt::format("{}: {}: nothing to map", config.dataset.file, why));
}

}  // namespace ariadne::slam_app
