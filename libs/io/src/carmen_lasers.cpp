#include "carmen_lasers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "input_file.h"
#include "text_fields.h"

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;

constexpr std::size_t kSurveyedScans = 200;
constexpr std::size_t kLongest = 16;

/// FLASER's better half is ROBOTLASER1.
const char* betterThan(const std::string& label) {
  if (label == "FLASER") return "ROBOTLASER1";
  return label == "RLASER" ? "ROBOTLASER2" : "";
}

bool isRaw(const std::string& label) { return label.rfind("RAWLASER", 0) == 0; }

TPose2D offsetOf(const CarmenScan& scan) {
  const TPose2D& robot = *scan.record.odom_from_robot;
  const TPose2D& laser = *scan.odom_from_laser;
  const double c = std::cos(robot.phi), s = std::sin(robot.phi);
  const double dx = laser.x - robot.x, dy = laser.y - robot.y;
  return {c * dx + s * dy, -s * dx + c * dy, std::remainder(laser.phi - robot.phi, 2 * M_PI)};
}

}  // namespace

CarmenLasers::CarmenLasers(const std::filesystem::path& path, double field_of_view_deg)
    : fans_(params_, field_of_view_deg) {
  survey(path);
  for (auto& [label, laser] : lasers_)
    if (isUsed(label)) settle(label, laser);
  if (!posed_.empty()) remarkOnRawLasers();
}

void CarmenLasers::survey(const std::filesystem::path& path) {
  InputFile file(path);
  std::vector<std::string_view> words;
  std::string_view line;
  std::string problem;
  bool too_long = false;
  std::size_t scans = 0;
  while (scans < kSurveyedScans && file.line(line, too_long)) {
    if (too_long) continue;
    splitFields(line, words);
    if (words.empty()) continue;
    const CarmenLine kind = kindOf(words);
    if (kind == CarmenLine::param) takeParam(words, scans > 0);
    if (kind != CarmenLine::scan && kind != CarmenLine::raw_scan) continue;
    const auto scan = parseCarmenScan(words, problem);
    if (!scan) continue;
    look(*scan);
    ++scans;
  }
  // A PARAM may stand anywhere: no error before the whole log was looked through.
  const auto is_used = [this](const std::string& label) { return isUsed(label); };
  bool known = fans_.allKnown(is_used);
  while (!known && file.line(line, too_long)) {
    if (too_long || line.find("PARAM") == line.npos) continue;
    splitFields(line, words);
    if (words.empty() || kindOf(words) != CarmenLine::param) continue;
    takeParam(words, true);
    known = fans_.allKnown(is_used);
  }
  surveyed_ = true;
}

/// Those that have no counterpart among the lines with poses.
void CarmenLasers::remarkOnRawLasers() {
  for (const std::string& label : raw_) {
    const char number = label.back();
    const bool seen = posed_.count(std::string("ROBOTLASER") + number) > 0 ||
                      (number == '1' && posed_.count("FLASER") > 0) ||
                      (number == '2' && posed_.count("RLASER") > 0);
    if (!seen)
      remarks_.push_back(fmt::format("{} lines are left out: they carry no pose, others do ({})",
                                     label, fmt::join(posed_, ", ")));
  }
}

void CarmenLasers::look(const CarmenScan& scan) {
  const std::string& label = scan.record.scan->sensorLabel;
  (isRaw(label) ? raw_ : posed_).insert(label);
  Laser& laser = lasers_[label];
  laser.bare = !scan.fan;
  if (scan.odom_from_laser) laser.offsets.push_back(offsetOf(scan));
  fans_.meet(scan);
  for (const float range : scan.record.beams.ranges_m) {
    if (!(range < kCarmenMaxRange_m)) continue;
    if (laser.longest.size() == kLongest && range <= *laser.longest.begin()) continue;
    laser.longest.insert(range);
    if (laser.longest.size() > kLongest) laser.longest.erase(laser.longest.begin());
  }
}

bool CarmenLasers::isUsed(const std::string& label) const {
  if (isRaw(label)) return posed_.empty();
  return posed_.count(betterThan(label)) == 0;
}

void CarmenLasers::settle(const std::string& label, Laser& laser) {
  laser.params = params_.of(label);
  laser.place = placeOf(laser.offsets, laser.params);
  if (!laser.place.remark.empty())
    remarks_.push_back(fmt::format("{} lines: {}", label, laser.place.remark));
  const TPose2D& at = laser.place.robot_from_laser;
  if (!laser.place.source.empty() && at != TPose2D())
    notes_.push_back(fmt::format("{}: at x {:.3f} y {:.3f} m, yaw {:.2f} degrees, {}", label, at.x,
                                 at.y, at.phi * 180 / M_PI, laser.place.source));
  if (laser.bare) settleRange(label, laser);
}

/// A PARAM's maximum range may be one that the robot's programs were to heed, not the laser's: it
/// is believed when readings beyond it are none or a few codes.
void CarmenLasers::settleRange(const std::string& label, Laser& laser) {
  constexpr std::size_t kMostCodes = 4;
  const auto& param = laser.params.max_range_m;
  if (!param || param->value >= kCarmenMaxRange_m) return;
  const auto max_range_m = static_cast<float>(param->value);
  const auto beyond = static_cast<std::size_t>(
      std::distance(laser.longest.upper_bound(max_range_m), laser.longest.end()));
  if (!(param->value > 0) || beyond > kMostCodes) {
    remarks_.push_back(
        fmt::format("{} lines: {} is not used: there are readings beyond it", label, param->text));
    return;
  }
  laser.max_range_m = max_range_m;
  notes_.push_back(fmt::format("{}: up to {:g} m by {}", label, param->value, param->text));
}

void CarmenLasers::complete(CarmenScan& scan) {
  auto& obs = *scan.record.scan;
  auto& [ranges, valid] = scan.record.beams;
  const Laser& laser = lasers_[obs.sensorLabel];
  if (laser.max_range_m > 0) obs.maxRange = laser.max_range_m;
  for (const float range : ranges) valid.push_back(range < obs.maxRange ? 1 : 0);
  const FanChoice& choice = fans_.of(scan, notes_, remarks_);
  if (!choice.fan) {
    scan.record.problem = choice.problem;
    obs.aperture = 0;
    return;
  }
  const double span = choice.fan->step_rad * (static_cast<double>(ranges.size()) - 1);
  obs.aperture = static_cast<float>(std::abs(span));
  obs.rightToLeft = span >= 0;
  // MRPT's beams are symmetric about the sensor's axis, so an uneven fan turns the sensor.
  obs.sensorPose = mrpt::poses::CPose3D(laser.place.robot_from_laser) +
                   mrpt::poses::CPose3D(0, 0, 0, choice.fan->start_rad + span / 2, 0, 0);
}

void CarmenLasers::takeParam(const std::vector<std::string_view>& words, bool scans_began) {
  using Place = CarmenParams::Place;
  const Place place = !scans_began ? Place::header : surveyed_ ? Place::later : Place::among;
  if (const auto remark = params_.take(words, place)) remarks_.push_back(*remark);
}

}  // namespace ariadne::io
