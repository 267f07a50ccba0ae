#include "carmen_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "ariadne/geometry/pose.h"

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;

constexpr double kFarthestByLines_m = 1.5;
constexpr double kFarthestByParam_m = 10;  // a car's
constexpr double kSameOffset_m = 0.05;
constexpr double kSameOffset_rad = 0.05;

double wrapped(double angle) { return std::remainder(angle, 2 * M_PI); }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool areSame(const TPose2D& a, const TPose2D& b) {
  return geometry::distance(a, b) < kSameOffset_m &&
         std::abs(wrapped(a.phi - b.phi)) < kSameOffset_rad;
}

/// The offset that most lines agree on; nullopt when they do not. The two poses of a line may have
/// been rounded, or taken a moment apart; in some logs the laser's is another kind of estimate.
std::optional<TPose2D> agreedOffset(const std::vector<TPose2D>& offsets) {
  if (offsets.empty()) return std::nullopt;
  std::vector<double> x, y, turn;
  for (const TPose2D& o : offsets) {
    x.push_back(o.x);
    y.push_back(o.y);
    turn.push_back(wrapped(o.phi - offsets[0].phi));
  }
  const TPose2D middle(median(x), median(y), wrapped(offsets[0].phi + median(turn)));
  if (std::hypot(middle.x, middle.y) > kFarthestByLines_m) return std::nullopt;
  const auto agrees = std::count_if(offsets.begin(), offsets.end(),
                                    [&](const TPose2D& o) { return areSame(o, middle); });
  if (2 * static_cast<std::size_t>(agrees) <= offsets.size()) return std::nullopt;
  const bool none = std::hypot(middle.x, middle.y) < 1e-3 && std::abs(middle.phi) < 2e-3;
  return none ? TPose2D() : middle;
}

/// Radians, as CARMEN has them; what is more than a turn must be degrees.
double turnOf(const CarmenParam& param) {
  return std::abs(param.value) > 2.1 * M_PI ? param.value * M_PI / 180 : param.value;
}

/// As CARMEN's module robot places its lasers: a rear laser without an angle of its own looks back,
/// and its offset counts along its axis.
std::optional<TPose2D> offsetByParams(const CarmenLaserParams& params) {
  if (!params.ahead_m && !params.left_m && !params.turn) return std::nullopt;
  const bool turned = params.rear && !params.turn;
  TPose2D offset;
  if (params.ahead_m) offset.x = params.ahead_m->value * (turned ? -1 : 1);
  if (params.left_m) offset.y = params.left_m->value;
  offset.phi = turned ? M_PI : params.turn ? wrapped(turnOf(*params.turn)) : 0;
  if (std::hypot(offset.x, offset.y) > kFarthestByParam_m) return std::nullopt;
  return offset;
}

std::string namesOf(const CarmenLaserParams& params) {
  std::string names;
  for (const auto* param : {&params.ahead_m, &params.left_m, &params.turn})
    if (*param) names += (names.empty() ? "" : ", ") + (*param)->text;
  return names;
}

std::string asText(const TPose2D& p) {
  return fmt::format("x {:.2f} y {:.2f} m, yaw {:.1f} degrees", p.x, p.y, p.phi * 180 / M_PI);
}

}  // namespace

LaserPlace placeOf(const std::vector<TPose2D>& offsets, const CarmenLaserParams& params) {
  const auto by_lines = agreedOffset(offsets);
  const auto by_params = offsetByParams(params);
  const std::string names = namesOf(params);
  LaserPlace place;
  if (!names.empty() && !by_params) place.remark = names + ": farther away than any laser sits";
  if (by_lines && *by_lines != TPose2D()) {
    place.robot_from_laser = *by_lines;
    place.source = "by its lines";
    if (by_params && !areSame(*by_lines, *by_params))
      place.remark = fmt::format("by its lines the laser sits at {}; {} is not used",
                                 asText(*by_lines), names);
    return place;
  }
  if (by_params) {
    place.robot_from_laser = *by_params;
    place.source = "by " + names;
  }
  if (!offsets.empty() && !by_lines) {
    place.remark = fmt::format(
        "laser pose and robot pose have no constant offset; the laser is taken to be at {}",
        by_params ? asText(*by_params) + ", " + place.source : "the robot's centre");
  } else if (offsets.empty() && !by_params) {
    place.robot_from_laser.phi = params.rear ? M_PI : 0;
    place.remark = fmt::format(
        "nothing says where the laser sits (PARAM robot_{}laser_offset); it is taken to be at the "
        "robot's centre, looking {}",
        params.rear ? "rear" : "front", params.rear ? "back" : "ahead");
  }
  return place;
}

}  // namespace ariadne::io
