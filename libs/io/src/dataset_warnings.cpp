#include "dataset_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ariadne::io {
namespace {

void tellOfJumps(const OdometryJumps& jumps, std::vector<std::string>& lines) {
  if (jumps.count > 0)
    lines.push_back(fmt::format(
        "the odometry jumped {} times, first by {:.2f} m and {:.0f} degrees in {:.3f} s to scan {} "
        "(stamp {:.3f}): it was reset, or the robot was carried; these steps are not believed",
        jumps.count, jumps.distance_m, jumps.turn_deg, jumps.span_s, jumps.scan, jumps.time_s));
}

void tellOfClocks(const DatasetCounts& counts, std::vector<std::string>& lines) {
  const ClockSetBacks& scans = counts.scan_clock;
  if (scans.count > 0)
    lines.push_back(fmt::format(
        "the clock was set back {} times, first from {:.3f} to {:.3f} s: no scan is lost by that; "
        "the poses keep the log's stamps",
        scans.count, scans.from_s, scans.to_s));
  const ClockSetBacks& odometry = counts.odometry_clock;
  if (odometry.count != scans.count && odometry.count > 0)
    lines.push_back(fmt::format(
        "the odometry's clock was set back {} times, first from {:.3f} to {:.3f} s, not at the "
        "same places as the scans' clock",
        odometry.count, odometry.from_s, odometry.to_s));
}

constexpr std::size_t kMostCodesTold = 6;

/// "51.15 m 9264 times, 51.14 m 3020 times": the most frequent first.
std::string codesText(const std::map<long, std::size_t>& codes_mm) {
  std::vector<std::pair<std::size_t, long>> codes;
  for (const auto& [mm, count] : codes_mm) codes.emplace_back(count, mm);
  std::sort(codes.rbegin(), codes.rend());
  codes.resize(std::min(codes.size(), kMostCodesTold));
  std::vector<std::string> words;
  for (const auto& [count, mm] : codes)
    words.push_back(fmt::format("{:g} m {} times", static_cast<double>(mm) / 1000, count));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Empty where nothing but the file's own maximum range means "no return".
std::string noReturnText(const DatasetCounts& counts) {
  if (counts.beams_over_reach == 0) return "";
  std::string text = fmt::format("{} beams of {:g} m or more are taken for no return",
                                 counts.beams_over_reach, counts.no_return_from_m);
  if (counts.no_return_codes_mm.empty()) return text + ", as max_range_m says";
  text += fmt::format(": these ranges recur as no wall's do (most often {})",
                      codesText(counts.no_return_codes_mm));
  if (counts.no_return_from_step > 0)
    text += fmt::format(", from scan {} on", counts.no_return_from_step + 1);
  return text + "; [dataset] max_range_m sets another limit";
}

}  // namespace

std::vector<std::string> datasetWarnings(const DatasetCounts& counts, const RecordSource& records) {
  std::vector<std::string> lines = records.remarks();
  const std::array<std::pair<std::size_t, const char*>, 16> kinds = {{
      {counts.lines_malformed, "malformed lines skipped"},
      {counts.scans_backwards, "scans skipped: their stamps are out of order"},
      {counts.scans_not_planar, "scans skipped: the laser is tilted by more than 5 degrees"},
      {counts.scans_malformed, "scans skipped: beams, angles or sensor pose are impossible"},
      {counts.scans_other_lasers, "scans of other lasers skipped"},
      {counts.scans_without_stamp, "scans without a stamp take the time of the scan before"},
      {counts.odometry_backwards, "odometry readings skipped: their stamps are out of order"},
      {counts.odometry_malformed, "impossible odometry values skipped"},
      {counts.odometry_ignored, "odometry records of another kind or label ignored"},
      {counts.odometry_gaps, "scans are over 1 s away from an odometry reading"},
      {counts.beams_nan, "beams are NaN"},
      {counts.beams_negative, "beams are negative"},
      {counts.beams_zero, "beams are zero"},
      {counts.beams_too_near, "beams are nearer than [dataset] min_range_m"},
      {counts.beams_out_of_range, "beams are called valid beyond the maximum range"},
      {counts.beams_flagged, "beams within range are called invalid"},
  }};
  for (const auto& [count, text] : kinds)
    if (count > 0) lines.push_back(fmt::format("{} {}", count, text));
  if (const std::string text = noReturnText(counts); !text.empty()) lines.push_back(text);
  tellOfClocks(counts, lines);
  tellOfJumps(counts.odometry_jumps, lines);
  if (!records.damage().empty())
    lines.push_back(fmt::format("{}; what follows is lost", records.damage()));
  return lines;
}

}  // namespace ariadne::io
