// One line of a CARMEN log.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ariadne/io/dataset_records.h"

namespace ariadne::io {

/// A scan with both poses of its line.
struct CarmenScan {
  LaserRecord record;  ///< sensorPose: only the turn of the beams' middle against the laser's axis
  mrpt::math::TPose2D odom_from_laser;
};

/// Whether the words are a line with a scan that `parseCarmenScan` knows.
bool isCarmenScan(const std::vector<std::string_view>& words);

/// The scan; nullopt and `problem` when the line is malformed.
std::optional<CarmenScan> parseCarmenScan(const std::vector<std::string_view>& words,
                                          std::string& problem);

/// Beams of FLASER lines, which carry no angles: `count` tells. The first is at -fov / 2.
struct CarmenFan {
  double start_rad = 0;
  double step_rad = 0;
};
/// 181, 361, 721: both ends of 180 degrees; 180, 360, 720: the left end is missing; 101, 401 and
/// 100, 400: the same of 100 degrees (a SICK's other setting).
CarmenFan carmenFan(std::size_t count);

}  // namespace ariadne::io
