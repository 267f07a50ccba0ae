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
// A SICK LMS in centimetres says 81.91, 81.90 or 81.83 for "nothing", and measures up to 80 m.
constexpr float kDefaultMaxRange_m = 80;
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

void setRanges(mrpt::obs::CObservation2DRangeScan& scan, Reader& line, std::size_t count) {
  scan.resizeScan(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Beyond a float's reach is beyond any laser's.
    const double word = line.number("range", false);
    const auto range = static_cast<float>(std::isfinite(word) ? std::clamp(word, -1e9, 1e9) : word);
    scan.setScanRange(i, range);
    scan.setScanRangeValidity(i, range < scan.maxRange);
  }
}

void setFan(mrpt::obs::CObservation2DRangeScan& scan, const CarmenFan& fan) {
  const double span = fan.step_rad * (static_cast<double>(scan.getScanSize()) - 1);
  scan.aperture = static_cast<float>(span);
  // MRPT's beams are symmetric about the sensor's axis, so an uneven fan turns the sensor.
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0, fan.start_rad + span / 2, 0, 0);
}

}  // namespace

CarmenFan carmenFan(std::size_t count) {
  constexpr double kDegree = M_PI / 180;
  const std::size_t steps = count - count % 2;  // an odd count has a beam at each end
  const bool narrow = steps == 100 || steps == 400;
  const double fov = narrow ? 100 * kDegree : 180 * kDegree;
  return {-fov / 2, steps == 0 ? 0 : fov / static_cast<double>(steps)};
}

bool isCarmenScan(const Words& words) {
  return !words.empty() && (words[0] == "FLASER" || words[0] == "RLASER" ||
                            words[0] == "ROBOTLASER1" || words[0] == "ROBOTLASER2");
}

std::optional<CarmenScan> parseCarmenScan(const Words& words, std::string& problem) {
  CarmenScan out;
  out.record.scan = mrpt::obs::CObservation2DRangeScan::Create();
  auto& scan = *out.record.scan;
  scan.sensorLabel = std::string(words[0]);
  scan.rightToLeft = true;
  scan.maxRange = kDefaultMaxRange_m;
  Reader line(words, 1);
  if (words[0] == "FLASER" || words[0] == "RLASER") {
    const std::size_t count = line.count("number of ranges");
    setRanges(scan, line, count);
    setFan(scan, carmenFan(count));
    out.odom_from_laser = line.pose("laser pose");
    out.record.odom_from_robot = line.pose("robot pose");
  } else {
    line.number("laser type");
    CarmenFan fan;
    fan.start_rad = line.number("start angle");
    line.number("field of view");
    fan.step_rad = line.number("angular resolution");
    const double reach = line.number("maximum range");
    if (reach > 0 && reach < 1000) scan.maxRange = static_cast<float>(reach);
    line.number("accuracy");
    line.number("remission mode");
    const std::size_t count = line.count("number of ranges");
    setRanges(scan, line, count);
    setFan(scan, fan);
    line.pass(line.count("number of remissions"));
    out.odom_from_laser = line.pose("laser pose");
    out.record.odom_from_robot = line.pose("robot pose");
    line.pass(5);  // velocities, safety distances, turning axis
  }
  out.record.time_s = line.stamp();
  problem = line.problem();
  if (!problem.empty()) return std::nullopt;
  if (out.record.time_s) scan.timestamp = clockOfSeconds(*out.record.time_s);
  return out;
}

}  // namespace ariadne::io
