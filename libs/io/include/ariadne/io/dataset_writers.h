// Steps into a file that other programs read: MRPT rawlogs and CARMEN logs.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>

#include "ariadne/models/sensor_step.h"

namespace ariadne::io {

/// Gives the steps one by one, nullopt at the end.
using NextStep = std::function<std::optional<models::SensorStep>()>;

/// Writes a gzip-compressed rawlog of pairs of action and sensory frame, as MRPT's stock programs
/// want it. The first action is no motion: where the odometry started is not kept. Returns the
/// number of steps. The file appears whole or not at all; throws core::Error naming it.
std::size_t writeRawlog(const std::filesystem::path& path, const NextStep& next);

/// The same as single observations, CObservationOdometry and scan: odometry and, at MRPT's 100 ns,
/// times are read back to the bit. Returns and throws as writeRawlog.
std::size_t writeObservationRawlog(const std::filesystem::path& path, const NextStep& next);

/// The kind of line that a laser's scans are written as.
enum class CarmenLaser {
  /// ROBOTLASER1 lines carry start angle, resolution and maximum range: any planar laser fits.
  robotlaser,
  /// FLASER lines are read by older programs, but fit only a SICK's 180 or 100 degrees (else
  /// core::Error) and 80 m; no return becomes 81.91.
  flaser
};

/// Writes a CARMEN log, gzip-compressed if `path` ends in .gz: an ODOM and a laser line a step.
/// Ranges keep all their digits, poses 1e-9 m and rad, stamps 1e-7 s. Lost: the laser's height,
/// its label, and why a beam without return was invalid. A laser that is upside down or scans
/// clockwise has its beams turned round. Returns and throws as writeRawlog.
std::size_t writeCarmen(const std::filesystem::path& path, const NextStep& next,
                        CarmenLaser laser = CarmenLaser::robotlaser);

}  // namespace ariadne::io
