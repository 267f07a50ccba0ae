// One line of a CARMEN log.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ariadne/io/dataset_records.h"
#include "carmen_fan_choice.h"

namespace ariadne::io {

/// A SICK LMS in centimetres says 81.91, 81.90 or 81.83 for "nothing", and measures up to 80 m.
constexpr float kCarmenMaxRange_m = 80;

/// A scan without its angles, its place on the robot, and which beams are valid: a line alone does
/// not say these.
struct CarmenScan {
  LaserRecord record;
  std::optional<CarmenLineFan> fan;                    ///< ROBOTLASER and RAWLASER
  std::optional<mrpt::math::TPose2D> odom_from_laser;  ///< all but RAWLASER
};

enum class CarmenLine { scan, raw_scan, odometry, param, other };
/// What the words, at least one, are: FLASER, RLASER, ROBOTLASER1 to 5 with the robot's pose on the
/// line; RAWLASER1 to 5 without.
CarmenLine kindOf(const std::vector<std::string_view>& words);

/// The scan; nullopt and `problem` when the line is malformed.
std::optional<CarmenScan> parseCarmenScan(const std::vector<std::string_view>& words,
                                          std::string& problem);
/// Of an ODOM line.
std::optional<OdometryReading> parseCarmenOdometry(const std::vector<std::string_view>& words,
                                                   std::string& problem);

}  // namespace ariadne::io
