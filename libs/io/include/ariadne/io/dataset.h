// Datasets as a stream of steps: MRPT rawlogs (action-observation or observations only) and CARMEN
// logs, gzip or not, told apart by their content. Memory is bounded whatever the file's size or
// whatever its headers claim; everything but 2D lasers and odometry is dropped as it comes.
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/io/ros_options.h"
#include "ariadne/models/sensor_step.h"

namespace ariadne::io {

/// How a log is read; the defaults take what the log itself says.
struct DatasetOptions {
  /// The laser to use: a rawlog's sensorLabel; FLASER, RLASER, ROBOTLASER1, ... in a CARMEN log.
  /// Empty: the only one. (FLASER repeats ROBOTLASER1 where a log has both: the latter is used;
  /// RAWLASER1 is used where a log has lines of no other kind.)
  std::string laser_label;
  /// Over 0: from the first to the last beam of a CARMEN log's lasers, degrees, whatever the log
  /// says; of an even number of beams the left end is missing (180 beams are -90 to 89 degrees).
  double field_of_view_deg = 0;
  /// Readings at or over this are no return, m. 0: the file's maximum range (80 where it says
  /// none), or the code for no return below it that the readings themselves give away.
  double max_range_m = 0;
  /// Readings under this are bad, m: error codes of Hokuyos are 1 to 19 mm, and a laser's housing
  /// is wider than 3 cm.
  double min_range_m = 0.03;
  /// Off: poses, increments and readings of the log are not looked at, all steps are at (0, 0, 0),
  /// and a log without odometry is fine.
  bool use_odometry = true;
  RosOptions ros = {};
  /// Called now and then while a recording of ROS is looked through before its first step, with
  /// the share that was; false ends it with core::Error.
  std::function<bool(double)> goes_on = nullptr;
};

/// How often a clock was set back or started over, and the stamps about the first time.
struct ClockSetBacks {
  std::size_t count = 0;
  double from_s = 0;
  double to_s = 0;
};

/// Steps of the odometry that no robot makes (models::JumpDetector), and the first of them.
struct OdometryJumps {
  std::size_t count = 0;
  std::size_t scan = 0;  ///< that it led to, from 1
  double time_s = 0;     ///< stamp of this scan
  double span_s = 0;     ///< since the scan before
  double distance_m = 0;
  double turn_deg = 0;
};

/// What was met so far, final after the last step.
struct DatasetCounts {
  std::size_t steps = 0;  ///< given out, each with a scan
  std::size_t beams = 0;  ///< in these; those that are not valid are counted by cause:
  std::size_t beams_no_return = 0;
  std::size_t beams_out_of_range = 0;  ///< called valid in the file, yet beyond the maximum range
  std::size_t beams_nan = 0;
  std::size_t beams_zero = 0;
  std::size_t beams_negative = 0;
  std::size_t beams_too_near = 0;  ///< under DatasetOptions::min_range_m
  std::size_t beams_flagged = 0;   ///< called invalid in the file, range within reach

  /// Where no return begins, m: max_range_m as set, or the code that was recognised; 0: neither.
  double no_return_from_m = 0;
  std::size_t no_return_from_step = 0;  ///< the first step that it was known for
  /// Of beams_no_return, those below the file's own maximum range.
  std::size_t beams_over_reach = 0;
  /// How often each of these was met where a code was recognised, by millimetres.
  std::map<long, std::size_t> no_return_codes_mm;

  std::size_t scans_backwards = 0;      ///< skipped: one stamp out of order, behind or ahead
  std::size_t scans_not_planar = 0;     ///< skipped: laser tilted by more than 5 degrees
  std::size_t scans_malformed = 0;      ///< skipped: fewer than 2 beams, impossible angles or pose
  std::size_t scans_other_lasers = 0;   ///< skipped: another label
  std::size_t scans_without_stamp = 0;  ///< used, with the time of the scan before
  std::size_t odometry_backwards = 0;   ///< readings skipped, as scans_backwards
  std::size_t odometry_malformed = 0;   ///< skipped: not finite or over 100 m in a step
  std::size_t odometry_ignored = 0;     ///< of another kind or label than the first
  std::size_t odometry_gaps = 0;  ///< scans over 1 s away from a reading; the nearest pose is used
  std::size_t lines_malformed = 0;  ///< of a text log, skipped
  ClockSetBacks scan_clock;         ///< nothing is skipped there
  ClockSetBacks odometry_clock;     ///< of readings
  OdometryJumps odometry_jumps;     ///< SensorStep::odometry_jumped is set there
};

/// Steps in the file's order with the file's stamps. They go on (equal stamps are fine) except
/// where the clock was set back, see DatasetCounts::scan_clock. Contract for the scans: `maxRange`
/// is positive; a beam is valid exactly when 0 < range < maxRange; a beam without return is invalid
/// and has range >= maxRange; any other bad beam (NaN, zero, negative, flagged) is invalid with
/// range 0. The laser is planar (perhaps upside down): sensorPose says where it is on the robot.
/// odom_from_robot is where the odometry has the robot at the scan's time: increments added up
/// from the origin, or readings interpolated, or, in CARMEN logs, the robot's pose on the line.
/// Where the odometry jumped, SensorStep::odometry_jumped says so; the pose is still the
/// odometry's.
class StepSource {
 public:
  virtual ~StepSource() = default;
  /// The next step, nullopt at the end of the file or at the damage where it ends early. Throws
  /// core::Error at the end when most scans had to be skipped for their stamps.
  virtual std::optional<models::SensorStep> next() = 0;
  /// How much of the file was read, 0 to 1.
  virtual double fraction() const = 0;
  /// Of what was read up to now.
  virtual const DatasetCounts& counts() const = 0;
  /// Counted, one line a kind; final after the last step.
  virtual std::vector<std::string> warnings() const = 0;
  /// Label of the laser whose scans these are.
  virtual const std::string& laserLabel() const = 0;
};

/// Opens a dataset and reads far enough to know that it can be mapped. Throws core::Error naming
/// the file when it cannot: unreadable, empty, of another kind, without laser, without odometry,
/// with several lasers and no label (the message lists the labels), with a laser whose angles
/// nobody says, damaged before the first step, most of the first scans out of order.
std::unique_ptr<StepSource> openDataset(const std::filesystem::path& path,
                                        const DatasetOptions& options = {});

}  // namespace ariadne::io
