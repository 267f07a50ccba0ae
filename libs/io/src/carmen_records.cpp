#include "carmen_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "text_fields.h"

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;

constexpr std::size_t kSurveyedScans = 200;
constexpr double kFarthestLaser_m = 1.5;
constexpr double kSameOffset_m = 0.05;
constexpr double kSameOffset_rad = 0.05;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double wrapped(double angle) { return std::remainder(angle, 2 * M_PI); }

/// The offset that most lines agree on; nullopt when they do not. The two poses of a line may have
/// been rounded, or taken a moment apart; in some logs the laser's is another kind of estimate.
std::optional<TPose2D> agreedOffset(const std::vector<TPose2D>& offsets) {
  std::vector<double> x, y, turn;
  for (const TPose2D& o : offsets) {
    x.push_back(o.x);
    y.push_back(o.y);
    turn.push_back(wrapped(o.phi - offsets[0].phi));
  }
  const TPose2D middle(median(x), median(y), wrapped(offsets[0].phi + median(turn)));
  if (std::hypot(middle.x, middle.y) > kFarthestLaser_m) return std::nullopt;
  const auto agrees = std::count_if(offsets.begin(), offsets.end(), [&](const TPose2D& o) {
    return std::hypot(o.x - middle.x, o.y - middle.y) < kSameOffset_m &&
           std::abs(wrapped(o.phi - middle.phi)) < kSameOffset_rad;
  });
  if (2 * static_cast<std::size_t>(agrees) <= offsets.size()) return std::nullopt;
  const bool none = std::hypot(middle.x, middle.y) < 1e-3 && std::abs(middle.phi) < 2e-3;
  return none ? TPose2D() : middle;
}

}  // namespace

CarmenRecords::CarmenRecords(const std::filesystem::path& path) : path_(path), file_(path) {
  surveyLasers();
}

void CarmenRecords::surveyLasers() {
  InputFile file(path_);
  std::map<std::string, std::vector<TPose2D>> offsets;
  std::string_view line;
  std::string problem;
  bool too_long = false;
  for (std::size_t scans = 0; scans < kSurveyedScans && file.line(line, too_long);) {
    if (too_long) continue;
    splitFields(line, words_);
    if (!isCarmenScan(words_)) continue;
    const auto scan = parseCarmenScan(words_, problem);
    if (!scan) continue;
    const TPose2D robot = *scan->record.odom_from_robot;
    const TPose2D laser = scan->odom_from_laser;
    const double c = std::cos(robot.phi), s = std::sin(robot.phi);
    const double dx = laser.x - robot.x, dy = laser.y - robot.y;
    offsets[scan->record.scan->sensorLabel].push_back(
        {c * dx + s * dy, -s * dx + c * dy, wrapped(laser.phi - robot.phi)});
    ++scans;
  }
  for (const auto& [label, list] : offsets) {
    const auto offset = agreedOffset(list);
    robot_from_laser_[label] = offset.value_or(TPose2D());
    if (!offset)
      remarks_.push_back(
          fmt::format("{} lines: laser pose and robot pose have no constant offset; the laser is "
                      "taken to be at "
                      "the robot's centre",
                      label));
  }
  has_robotlaser_ = offsets.count("ROBOTLASER1") > 0;
}

std::optional<CarmenScan> CarmenRecords::nextScan() {
  std::string_view line;
  std::string problem;
  bool too_long = false;
  while (file_.line(line, too_long)) {
    ++line_number_;
    if (!too_long) splitFields(line, words_);
    if (!too_long && (words_.empty() || words_[0][0] == '#')) continue;
    std::optional<CarmenScan> scan;
    if (too_long) {
      problem = "over 1 MiB long";
    } else if (!isCarmenScan(words_)) {
      // Other messages are none of our business, but their kinds must not pile up.
      const std::string_view kind = words_[0].substr(0, 32);
      const bool plain = std::isalpha(static_cast<unsigned char>(kind[0])) != 0 &&
                         std::all_of(kind.begin(), kind.end(), [](unsigned char c) {
                           return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
                         });
      const bool known = classes_.size() < 100 || classes_.count(std::string(kind)) > 0;
      ++classes_[plain && known ? std::string(kind) : "other lines"];
      continue;
    } else {
      scan = parseCarmenScan(words_, problem);
    }
    if (!scan) {
      ++malformed_;
      if (!std::exchange(remarked_, true))
        remarks_.push_back(
            fmt::format("{}:{}: {} (first malformed line)", path_.string(), line_number_, problem));
      continue;
    }
    ++classes_[scan->record.scan->sensorLabel];
    // Where a log has both, FLASER repeats ROBOTLASER1 for older programs, without its angles.
    if (has_robotlaser_ && scan->record.scan->sensorLabel == "FLASER") continue;
    return scan;
  }
  return std::nullopt;
}

std::optional<LogRecord> CarmenRecords::next() {
  auto scan = nextScan();
  if (!scan) return std::nullopt;
  const auto offset = robot_from_laser_.find(scan->record.scan->sensorLabel);
  if (offset != robot_from_laser_.end())
    scan->record.scan->sensorPose =
        mrpt::poses::CPose3D(offset->second) + scan->record.scan->sensorPose;
  return std::move(scan->record);
}

}  // namespace ariadne::io
