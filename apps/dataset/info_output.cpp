#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "dataset_info.h"

namespace ariadne {
namespace {

const char* name(const std::string& label) { return label.empty() ? "(none)" : label.c_str(); }

/// A date for stamps that can be one; logs often count from their own beginning.
std::string date(double time_s) {
  if (!(time_s > 1e8 && time_s < 1e10)) return fmt::format("stamp {:.3f} s", time_s);
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(static_cast<std::time_t>(time_s)));
}

/// No "-0.00".
double plain(double value) { return std::abs(value) < 5e-4 ? 0 : value; }

void laserText(std::back_insert_iterator<std::string> out, const std::string& label,
               const LaserInfo& laser) {
  const std::string beams = laser.fewest_beams == laser.most_beams
                                ? fmt::format("{}", laser.most_beams)
                                : fmt::format("{} to {}", laser.fewest_beams, laser.most_beams);
  const std::string angle = laser.field_of_view_deg > 0
                                ? fmt::format("{:.2f} deg", laser.field_of_view_deg)
                                : "an unknown angle";
  fmt::format_to(out, "laser {}: {} scans, {} beams over {}, up to {:g} m", name(label),
                 laser.scans, beams, angle, laser.max_range_m);
  if (laser.rate_hz() > 0) fmt::format_to(out, ", {:.2f} Hz", laser.rate_hz());
  if (!laser.place_known)
    fmt::format_to(out, "\n  where it is on the robot is not known");
  else
    fmt::format_to(out,
                   "\n  at x {:.3f} y {:.3f} z {:.3f} m, yaw {:.2f} pitch {:.2f} roll {:.2f} deg{}",
                   plain(laser.x_m), plain(laser.y_m), plain(laser.z_m), plain(laser.yaw_deg),
                   plain(laser.pitch_deg), plain(laser.roll_deg),
                   laser.planar ? "" : " (tilted: not for a map of the floor)");
  fmt::format_to(out,
                 "\n  longest time between scans {:.3f} s, stamps going backwards {}, missing {}\n",
                 laser.longest_gap_s, laser.stamps_backwards, laser.scans - laser.stamps);
}

std::string odometryText(const DatasetInfo& info) {
  std::string text;
  auto out = std::back_inserter(text);
  const auto part = [&](std::size_t count, const char* what) {
    if (count > 0) fmt::format_to(out, "{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  part(info.increments, "increments");
  part(info.readings, "readings");
  part(info.line_poses, "poses on laser lines");
  return text.empty() ? "none" : text;
}

nlohmann::json laserJson(const std::string& label, const LaserInfo& laser) {
  return {{"label", label},
          {"scans", laser.scans},
          {"beams", {laser.fewest_beams, laser.most_beams}},
          {"field_of_view_deg", laser.field_of_view_deg},
          {"max_range_m", laser.max_range_m},
          {"rate_hz", laser.rate_hz()},
          {"pose",
           {{"x_m", laser.x_m},
            {"y_m", laser.y_m},
            {"z_m", laser.z_m},
            {"yaw_deg", laser.yaw_deg},
            {"pitch_deg", laser.pitch_deg},
            {"roll_deg", laser.roll_deg}}},
          {"pose_known", laser.place_known},
          {"planar", laser.planar},
          {"first_stamp_s", laser.first_s},
          {"last_stamp_s", laser.last_s},
          {"longest_gap_s", laser.longest_gap_s},
          {"stamps_backwards", laser.stamps_backwards},
          {"stamps_missing", laser.scans - laser.stamps}};
}

nlohmann::json countsJson(const io::DatasetCounts& c) {
  return {{"steps", c.steps},
          {"beams", c.beams},
          {"beams_no_return", c.beams_no_return},
          {"beams_out_of_range", c.beams_out_of_range},
          {"beams_nan", c.beams_nan},
          {"beams_zero", c.beams_zero},
          {"beams_negative", c.beams_negative},
          {"beams_too_near", c.beams_too_near},
          {"beams_flagged", c.beams_flagged},
          {"beams_over_reach", c.beams_over_reach},
          {"scans_backwards", c.scans_backwards},
          {"scans_not_planar", c.scans_not_planar},
          {"scans_malformed", c.scans_malformed},
          {"scans_other_lasers", c.scans_other_lasers},
          {"scans_without_stamp", c.scans_without_stamp},
          {"odometry_backwards", c.odometry_backwards},
          {"odometry_malformed", c.odometry_malformed},
          {"odometry_ignored", c.odometry_ignored},
          {"odometry_gaps", c.odometry_gaps},
          {"lines_malformed", c.lines_malformed}};
}

nlohmann::json noReturnJson(const io::DatasetCounts& c) {
  nlohmann::json codes = nlohmann::json::array();
  for (const auto& [mm, beams] : c.no_return_codes_mm)
    codes.push_back({{"range_m", static_cast<double>(mm) / 1000}, {"beams", beams}});
  return {{"from_m", c.no_return_from_m > 0 ? nlohmann::json(c.no_return_from_m) : nullptr},
          {"from_step", c.no_return_from_step},
          {"codes", codes}};
}

}  // namespace

std::string infoAsText(const DatasetInfo& info) {
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}, {} bytes\nholds:", info.path.string(), info.format, info.bytes);
  for (const auto& [kind, count] : info.classes) fmt::format_to(out, " {} {}", count, kind);
  fmt::format_to(out, "\nodometry: {}\n", odometryText(info));
  for (const auto& [label, laser] : info.lasers) laserText(out, label, laser);
  if (info.counts.steps > 0) {
    const auto& c = info.counts;
    const double share = c.beams == 0 ? 0 : 100.0 / static_cast<double>(c.beams);
    fmt::format_to(out, "steps with laser {}: {}, {:.1f} s from {}\n", name(info.laser), c.steps,
                   info.duration_s, date(info.begin_s));
    fmt::format_to(
        out,
        "path: {:.2f} m, {:.0f} deg turned, within {:.1f} x {:.1f} m; longest step {:.2f} "
        "m\n",
        info.path_length_m, info.turned_deg, info.width_m, info.height_m, info.longest_step_m);
    fmt::format_to(out, "beams: {}, {:.1f} % without return\n", c.beams,
                   share * static_cast<double>(c.beams_no_return));
  }
  for (const std::string& line : info.notes) fmt::format_to(out, "note: {}\n", line);
  for (const std::string& line : info.warnings) fmt::format_to(out, "warning: {}\n", line);
  if (info.can_be_mapped && info.lasers.size() > 1)
    fmt::format_to(out, "can be mapped: yes, with one of the lasers chosen by its label\n");
  else if (info.can_be_mapped)
    fmt::format_to(out, "can be mapped: yes\n");
  else
    fmt::format_to(out, "can be mapped: no: {}\n", info.why_not);
  return text;
}

std::string infoAsJson(const DatasetInfo& info) {
  nlohmann::json lasers = nlohmann::json::array();
  for (const auto& [label, laser] : info.lasers) lasers.push_back(laserJson(label, laser));
  const nlohmann::json json = {{"file", info.path.string()},
                               {"format", info.format},
                               {"bytes", info.bytes},
                               {"holds", info.classes},
                               {"odometry",
                                {{"increments", info.increments},
                                 {"readings", info.readings},
                                 {"line_poses", info.line_poses}}},
                               {"lasers", lasers},
                               {"laser", info.laser},
                               {"begin_s", info.begin_s},
                               {"duration_s", info.duration_s},
                               {"path_length_m", info.path_length_m},
                               {"turned_deg", info.turned_deg},
                               {"longest_step_m", info.longest_step_m},
                               {"width_m", info.width_m},
                               {"height_m", info.height_m},
                               {"counts", countsJson(info.counts)},
                               {"notes", info.notes},
                               {"no_return", noReturnJson(info.counts)},
                               {"warnings", info.warnings},
                               {"can_be_mapped", info.can_be_mapped},
                               {"why_not", info.why_not}};
  // Labels come from the file and need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace ariadne
