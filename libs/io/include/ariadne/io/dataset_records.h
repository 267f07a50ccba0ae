// What a log holds, record by record and as it stands in the file: the layer below StepSource, for
// programs that describe a log instead of mapping it.
#pragma once
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ariadne/io/dataset.h"

namespace ariadne::io {

/// A motion since the increment before (CActionRobotMovement2D): m, rad, in the robot's frame.
struct OdometryIncrement {
  mrpt::math::TPose2D robot_from_next;
};

/// A reading of cumulative odometry (CObservationOdometry).
struct OdometryReading {
  std::optional<double> time_s;
  mrpt::math::TPose2D odom_from_robot;
  std::string label;
};

/// The beams of a scan as the file has them, unchecked.
struct RawBeams {
  std::vector<float> ranges_m;
  std::vector<char> valid;  ///< as many: not 0 for each that the file calls valid
};

/// A scan as the file has it, unchecked; `odom_from_robot` where it is on the same line (CARMEN).
struct LaserRecord {
  mrpt::obs::CObservation2DRangeScan::Ptr scan;  ///< still without its beams
  RawBeams beams;
  std::optional<double> time_s;
  std::optional<mrpt::math::TPose2D> odom_from_robot;
  std::string problem;      ///< why the beams' angles are not known; the aperture is 0 then
  bool place_known = true;  ///< of the laser on the robot; else the scan says its centre
};

/// One entry of a log.
using LogRecord = std::variant<OdometryIncrement, OdometryReading, LaserRecord>;

/// A log of any format as records, in the file's order.
class RecordSource {
 public:
  virtual ~RecordSource() = default;
  /// The next record; nullopt at the end or at the damage.
  virtual std::optional<LogRecord> next() = 0;
  /// Share of the file that was read, 0 to 1.
  virtual double fraction() const = 0;
  /// How often each class (rawlog) or line type (CARMEN) was met so far.
  virtual const std::map<std::string, std::size_t>& classes() const = 0;
  /// Where and how the file is broken; empty while it is not.
  virtual const std::string& damage() const = 0;
  /// Lines of text logs that could not be read and were passed over.
  virtual std::size_t malformedLines() const = 0;
  /// "MRPT rawlog", "CARMEN log", "ROS 1 bag", ...
  virtual const char* format() const = 0;
  /// What was noticed that is neither damage nor counted elsewhere.
  virtual const std::vector<std::string>& remarks() const = 0;
  /// What the records were taken to mean, and by what; nothing in it is wrong.
  virtual std::vector<std::string> notes() const { return {}; }
  /// Label of the laser that the options mean, where labels are not what they name it by.
  virtual std::string chosenLaser() const { return ""; }
  /// Why nothing of it can be mapped, where that was found out before; empty where it was not.
  virtual std::string whyNot() const { return ""; }
};

/// Throws core::Error naming the file when it is unreadable, empty or none of them.
std::unique_ptr<RecordSource> openRecords(const std::filesystem::path& path,
                                          const DatasetOptions& options = {});

}  // namespace ariadne::io
