#include "dataset_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/checks/checks.h"
#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/io/dataset_records.h"

namespace ariadne {
namespace {

constexpr double kDegrees = 180 / M_PI;
constexpr double kTilt_deg = 5;
constexpr double kLeastReturns = 0.1;  // default of [update] least_returns

/// Of a folder: of the files in it.
std::uintmax_t bytesOf(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::is_directory(path, code)) return std::filesystem::file_size(path);
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.is_regular_file(code)) bytes += entry.file_size(code);
  return bytes;
}

void describe(LaserInfo& laser, const mrpt::obs::CObservation2DRangeScan& scan) {
  const auto& pose = scan.sensorPose;
  laser.field_of_view_deg = scan.aperture * kDegrees;
  laser.max_range_m = scan.maxRange;
  laser.x_m = pose.x();
  laser.y_m = pose.y();
  laser.z_m = pose.z();
  laser.yaw_deg = pose.yaw() * kDegrees;
  laser.pitch_deg = pose.pitch() * kDegrees;
  laser.roll_deg = pose.roll() * kDegrees;
  laser.planar = std::abs(pose.getRotationMatrix()(2, 2)) >= std::cos(kTilt_deg / kDegrees);
}

class Collector {
 public:
  explicit Collector(DatasetInfo& info) : info_(info) {}
  void operator()(const io::OdometryIncrement&) { ++info_.increments; }
  void operator()(const io::OdometryReading&) { ++info_.readings; }
  void operator()(const io::LaserRecord& record) {
    const auto& scan = *record.scan;
    LaserInfo& laser = info_.lasers[scan.sensorLabel];
    const std::size_t beams = record.beams.ranges_m.size();
    if (laser.scans++ == 0) {
      describe(laser, scan);
      laser.fewest_beams = beams;
    }
    laser.place_known = record.place_known;
    laser.fewest_beams = std::min(laser.fewest_beams, beams);
    laser.most_beams = std::max(laser.most_beams, beams);
    if (record.odom_from_robot) ++info_.line_poses;
    if (!record.time_s) return;
    const double time_s = *record.time_s;
    if (laser.stamps++ == 0) {
      laser.first_s = time_s;
    } else if (time_s < laser.last_s) {
      ++laser.stamps_backwards;
      laser.set_back_s += laser.last_s - time_s;
    } else {
      laser.longest_gap_s = std::max(laser.longest_gap_s, time_s - laser.last_s);
    }
    laser.last_s = time_s;
  }

 private:
  DatasetInfo& info_;
};

void followSteps(DatasetInfo& info, io::StepSource& steps,
                 const std::function<void(double)>& progress) {
  std::optional<models::SensorStep> before;
  double left = 0, right = 0, bottom = 0, top = 0, set_back_s = 0;
  checks::DriveWatch watch({}, kLeastReturns);
  while (auto step = steps.next()) {
    const auto& pose = step->odom_from_robot;
    watch.add(*step);
    if (before && !step->odometry_jumped) {
      const auto& last = before->odom_from_robot;
      const double length = geometry::distance(pose, last);
      info.path_length_m += length;
      info.longest_step_m = std::max(info.longest_step_m, length);
      info.turned_deg += std::abs(std::remainder(pose.phi - last.phi, 2 * M_PI)) * kDegrees;
    } else if (!before) {
      info.begin_s = step->time_s;
      left = right = pose.x;
      bottom = top = pose.y;
    }
    if (before) set_back_s += std::max(0.0, before->time_s - step->time_s);
    info.duration_s = step->time_s - info.begin_s + set_back_s;
    left = std::min(left, pose.x);
    right = std::max(right, pose.x);
    bottom = std::min(bottom, pose.y);
    top = std::max(top, pose.y);
    step->scan.reset();
    before = std::move(step);
    progress(0.5 + steps.fraction() / 2);
  }
  info.width_m = right - left;
  info.height_m = top - bottom;
  info.counts = steps.counts();
  info.warnings = steps.warnings();
  const auto& c = info.counts;
  const auto findings =
      checks::checkLog(watch.figures(), c.scans_backwards + c.scans_not_planar + c.scans_malformed);
  for (const std::string& w : checks::warningsOf(findings)) info.warnings.push_back(w);
}

}  // namespace

double LaserInfo::rate_hz() const {
  const double span_s = last_s - first_s + set_back_s;
  return stamps > 1 && span_s > 0 ? static_cast<double>(stamps - 1) / span_s : 0;
}

DatasetInfo collectInfo(const std::filesystem::path& path, io::DatasetOptions options,
                        const std::function<void(double)>& progress) {
  DatasetInfo info;
  info.path = path;
  double looked_through = 0;  // of the whole work
  options.goes_on = [&](double share) {
    progress(looked_through = share / 6);
    return true;
  };
  const auto records = io::openRecords(path, options);
  options.goes_on = nullptr;
  info.format = records->format();
  info.bytes = bytesOf(path);
  Collector collect(info);
  while (const auto record = records->next()) {
    std::visit(collect, *record);
    progress(looked_through + (0.5 - looked_through) * records->fraction());
  }
  info.classes = records->classes();
  info.notes = records->notes();
  info.laser = options.laser_label;
  if (info.laser.empty() && !info.lasers.empty()) info.laser = info.lasers.begin()->first;
  try {
    // An unlabelled laser among labelled ones has a name in options only.
    const bool unlabelled = info.laser.empty() && info.lasers.size() > 1;
    options.laser_label = unlabelled ? "(none)" : info.laser;
    const auto steps = io::openDataset(path, options);
    followSteps(info, *steps, progress);
    const auto& c = info.counts;
    const std::size_t bad = c.beams_no_return + c.beams_out_of_range + c.beams_nan + c.beams_zero +
                            c.beams_negative + c.beams_too_near + c.beams_flagged;
    if (bad == c.beams) info.why_not = "no beam has a valid range";
  } catch (const core::UsageError&) {
    throw;  // the options are wrong, not the log
  } catch (const core::Error& e) {
    const std::string prefix = path.string() + ": ";
    info.why_not = e.what();
    if (info.why_not.rfind(prefix, 0) == 0) info.why_not.erase(0, prefix.size());
  }
  info.can_be_mapped = info.why_not.empty();
  return info;
}

}  // namespace ariadne
