#include "carmen_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rawlog_objects.h"
#include "text_fields.h"

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;
using Words = std::vector<std::string_view>;

constexpr std::size_t kMostBeams = 100'000;
constexpr double kLatest_s = 1e11;

/// Takes the words of a line one by one; the first that is wrong stays in `problem`.
class Reader {
 public:
  Reader(const Words& words, std::size_t at) : words_(words), at_(at) {}
  double number(const char* what, bool must_be_finite = true) {
    const auto value = at_ < words_.size() ? parseNumber(words_[at_]) : std::nullopt;
    if (!value || (must_be_finite && !std::isfinite(*value))) fail(what);
    ++at_;
    return value.value_or(0);
  }
  /// An angle that need not be there: a driver's division by zero says as little as a zero.
  double angle(const char* what) {
    const double value = number(what, false);
    return std::isfinite(value) ? value : 0;
  }
  std::size_t left() const { return words_.size() - std::min(at_, words_.size()); }
  bool isInteger() const { return left() > 0 && parseInteger(words_[at_]); }
  bool isAtMost(double most) const {
    const auto value = left() > 0 ? parseNumber(words_[at_]) : std::nullopt;
    return value && *value <= most;
  }
  std::size_t count(const char* what) {
    const auto word = at_ < words_.size() ? parseInteger(words_[at_]) : std::nullopt;
    const long value = word.value_or(-1);
    // The line holds as many words as it claims numbers, so no claim can be large.
    const auto most = static_cast<long>(std::min(words_.size(), kMostBeams));
    if (value < 0 || value > most) fail(what);
    ++at_;
    return problem_.empty() ? static_cast<std::size_t>(value) : 0;
  }
  TPose2D pose(const char* what) {
    TPose2D p;
    p.x = number(what);
    p.y = number(what);
    p.phi = number(what);
    return p;
  }
  void pass(std::size_t words) { at_ += words; }
  /// The stamp, if the line still has one.
  std::optional<double> stamp() {
    if (at_ >= words_.size()) return std::nullopt;
    const double time_s = number("stamp");
    if (std::abs(time_s) > kLatest_s) fail("stamp");
    return time_s;
  }
  const std::string& problem() const { return problem_; }

 private:
  void fail(const char* what) {
    if (!problem_.empty()) return;
    problem_ = at_ < words_.size() ? fmt::format("{} '{}'", what, words_[at_].substr(0, 40))
                                   : fmt::format("{} missing", what);
  }
  const Words& words_;
  std::size_t at_;
  std::string problem_;
};

std::vector<float> readRanges(Reader& line, std::size_t count) {
  std::vector<float> ranges(count);
  for (float& range : ranges) {
    // Beyond a float's reach is beyond any laser's.
    const double word = line.number("range", false);
    range = static_cast<float>(std::isfinite(word) ? std::clamp(word, -1e9, 1e9) : word);
  }
  return ranges;
}

/// Laser type to ranges and remissions. CARMEN's first releases wrote no remission mode (0 to 2),
/// and some programs write no remissions.
void readConfigured(CarmenScan& out, Reader& line) {
  line.number("laser type");
  out.fan.emplace();
  out.fan->start = line.angle("start angle");
  out.fan->field = line.angle("field of view");
  out.fan->step = line.angle("angular resolution");
  const double reach = line.number("maximum range");
  if (reach > 0 && reach < 1000) out.record.scan->maxRange = static_cast<float>(reach);
  line.number("accuracy");
  if (line.isAtMost(2)) line.number("remission mode");
  out.record.beams.ranges_m = readRanges(line, line.count("number of ranges"));
  if (line.isInteger()) line.pass(line.count("number of remissions"));
}

}  // namespace

CarmenLine kindOf(const Words& words) {
  const std::string_view kind = words[0];
  if (kind == "FLASER" || kind == "RLASER") return CarmenLine::scan;
  if (kind == "ODOM") return CarmenLine::odometry;
  if (kind == "PARAM") return CarmenLine::param;
  if (kind.empty() || kind.back() < '1' || kind.back() > '5') return CarmenLine::other;
  const std::string_view name = kind.substr(0, kind.size() - 1);
  if (name == "ROBOTLASER") return CarmenLine::scan;
  return name == "RAWLASER" ? CarmenLine::raw_scan : CarmenLine::other;
}

std::optional<CarmenScan> parseCarmenScan(const Words& words, std::string& problem) {
  CarmenScan out;
  out.record.scan = mrpt::obs::CObservation2DRangeScan::Create();
  auto& scan = *out.record.scan;
  scan.sensorLabel = std::string(words[0]);
  scan.maxRange = kCarmenMaxRange_m;
  Reader line(words, 1);
  const bool bare = words[0] == "FLASER" || words[0] == "RLASER";
  if (bare) {
    out.record.beams.ranges_m = readRanges(line, line.count("number of ranges"));
  } else {
    readConfigured(out, line);
  }
  if (kindOf(words) == CarmenLine::scan) {
    out.odom_from_laser = line.pose("laser pose");
    out.record.odom_from_robot = line.pose("robot pose");
    // Velocities, safety distances, turning axis, which old lines lack.
    if (!bare) line.pass(line.left() == 7 ? 4 : 5);
  }
  out.record.time_s = line.stamp();
  problem = line.problem();
  if (!problem.empty()) return std::nullopt;
  if (out.record.time_s) scan.timestamp = clockOfSeconds(*out.record.time_s);
  return out;
}

std::optional<OdometryReading> parseCarmenOdometry(const Words& words, std::string& problem) {
  Reader line(words, 1);
  OdometryReading reading;
  reading.odom_from_robot = line.pose("pose");
  line.pass(3);  // velocities, acceleration
  reading.time_s = line.stamp();
  problem = line.problem();
  if (!problem.empty()) return std::nullopt;
  return reading;
}

}  // namespace ariadne::io
