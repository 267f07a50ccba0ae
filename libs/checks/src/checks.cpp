#include "ariadne/checks/checks.h"

#include <fmt/format.h>

namespace ariadne::checks {
namespace {

// The bounds leave room about what good logs reach; doc/reference/logs.md has the figures.
constexpr double kMostSkipped = 0.2;
constexpr double kMostBlind = 0.05;
constexpr double kMostStanding = 0.05;
constexpr std::size_t kFewest = 5;  // scans, below which a share says nothing
constexpr double kShortestPath = 0.8;
constexpr double kLongestPath = 1.25;
constexpr double kLeastPath_m = 10;
constexpr double kLeastAccepted = 0.5;
constexpr std::size_t kLeastTried = 300;

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// A share of the scans, told where it is over `most`.
Check shareOfScans(const char* name, std::size_t part, std::size_t whole, double most,
                   const std::string& warning) {
  Check check{name, share(part, whole), ""};
  if (part >= kFewest && check.value > most) check.warning = warning;
  return check;
}

Check skippedScans(const DriveFigures& drive, std::size_t skipped) {
  const std::size_t all = drive.scans + skipped;
  return shareOfScans(
      "scans_skipped_share", skipped, all, kMostSkipped,
      fmt::format("only {} of {} scans could be used; the lines about skipped scans say why",
                  drive.scans, all));
}

Check blindScans(const DriveFigures& drive) {
  return shareOfScans(
      "blind_scans_share", drive.blind_scans, drive.scans, kMostBlind,
      fmt::format(
          "in {} of {} scans hardly a beam returned: there the path is the odometry's alone "
          "and nothing is mapped; [update] least_returns says how few are too few",
          drive.blind_scans, drive.scans));
}

Check standingScans(const DriveFigures& drive) {
  return shareOfScans(
      "standing_scans_share", drive.standing_scans, drive.scans, kMostStanding,
      fmt::format("the odometry stood still while the robot drove by its scans, in {} of {} scans "
                  "({:.1f} m in all): it is missing there; [dataset] odometry = scans maps by "
                  "the scans alone",
                  drive.standing_scans, drive.scans, drive.odometry_m));
}

Check pathLength(const DriveFigures& drive, const MapFigures& map) {
  Check check{"path_to_odometry", drive.odometry_m > 0 ? map.path_m / drive.odometry_m : 0, ""};
  if (drive.odometry_m >= kLeastPath_m && check.value < kShortestPath)
    check.warning = fmt::format(
        "the mapped path is {:.1f} m long, the odometry's {:.1f} m: matching the scans held the "
        "robot back; are readings that mean 'nothing' taken for walls (ariadne-dataset info says "
        "which there are; [dataset] max_range_m), or does the odometry count in other units",
        map.path_m, drive.odometry_m);
  if (map.path_m >= kLeastPath_m && map.path_m > kLongestPath * drive.odometry_m)
    check.warning = fmt::format(
        "the mapped path is {:.1f} m long, the odometry's {:.1f} m: either the odometry misses "
        "motion "
        "([dataset] odometry = scans maps without it), or the scans tell too little and the path "
        "wanders (a smaller [motion] noise holds it to the odometry)",
        map.path_m, drive.odometry_m);
  return check;
}

Check acceptedMatches(const MapFigures& map) {
  Check check{"matches_accepted_share", share(map.matches_accepted, map.matches_tried), ""};
  if (map.matches_tried >= kLeastTried && check.value < kLeastAccepted)
    check.warning = fmt::format(
        "only {:.0f} % of the scans fitted the map better than the odometry had them: scans and "
        "odometry do not belong together, or the laser is mounted otherwise than the log says",
        100 * check.value);
  return check;
}

}  // namespace

std::vector<Check> checkLog(const DriveFigures& drive, std::size_t skipped) {
  return {skippedScans(drive, skipped), blindScans(drive), standingScans(drive)};
}

std::vector<Check> checkMap(const DriveFigures& drive, const MapFigures& map) {
  return {{"updates_per_scan", share(map.updates, drive.scans), ""},
          pathLength(drive, map),
          acceptedMatches(map)};
}

std::vector<std::string> warningsOf(const std::vector<Check>& checks) {
  std::vector<std::string> warnings;
  for (const Check& check : checks)
    if (!check.warning.empty()) warnings.push_back(check.warning);
  return warnings;
}

}  // namespace ariadne::checks
