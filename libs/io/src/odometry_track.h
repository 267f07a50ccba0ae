// Where the odometry has the robot at a scan's time, whichever way the log says it.
#pragma once
#include <deque>
#include <optional>
#include <string>

#include "ariadne/io/dataset.h"
#include "ariadne/io/dataset_records.h"
#include "ariadne/models/odometry_jump.h"
#include "raw_step.h"
#include "time_gate.h"

namespace ariadne::io {

/// Scans go in, steps come out, in the same order. Increments are added up; readings are
/// interpolated, so a scan waits for the reading after it. The kind of odometry that is met first
/// is the one that is used. Where a clock was set back a stamp may come twice: the readings about
/// it that stand nearest to the scan in the file are used.
class OdometryTrack {
 public:
  /// @param use_odometry off: all poses are (0, 0, 0)
  OdometryTrack(DatasetCounts& counts, bool use_odometry)
      : counts_(counts), kind_(use_odometry ? Kind::unknown : Kind::none) {}

  void add(const OdometryIncrement& increment);
  void add(const OdometryReading& reading);
  /// A scan and the pose that increments or its own line give it; it waits for a better one where
  /// readings are used. @param place readings() when the scan was read
  void add(RawStep step, std::size_t place) { waiting_.push_back({std::move(step), place}); }
  /// How many readings were read so far.
  std::size_t readings() const { return readings_read_; }
  /// The pose of a scan that comes now; `line_pose` where its record has one. False: not possible.
  bool poseOfScan(const std::optional<mrpt::math::TPose2D>& line_pose, mrpt::math::TPose2D& pose);
  /// Nothing more will come: waiting scans take the last reading.
  void finish();
  std::optional<RawStep> pop();
  bool hasOdometry() const { return kind_ != Kind::unknown; }
  std::size_t waiting() const { return waiting_.size(); }

 private:
  enum class Kind { none, unknown, increments, readings, lines };
  struct Reading {
    mrpt::math::TPose2D odom_from_robot;
    std::size_t number = 0;  ///< from 0
    double time_s = 0;
    std::size_t jumps = 0;  ///< up to this one
  };
  struct Waiting {
    RawStep step;
    std::size_t place = 0;  ///< readings before it in the file
  };
  /// Indices of the readings about a stamp; the same twice where it lies outside of all.
  struct Pair {
    std::size_t before = 0;
    std::size_t after = 0;
  };
  bool useKind(Kind kind);
  void takeReadings();
  std::optional<Pair> readingsAbout(const Waiting& scan) const;
  std::size_t nearestReading(const Waiting& scan) const;
  bool locate(Waiting& scan);
  void countJump(const models::SensorStep& step);

  DatasetCounts& counts_;
  Kind kind_;
  mrpt::math::TPose2D sum_;
  std::optional<std::string> label_;
  std::size_t readings_read_ = 0;
  double last_read_s_ = 0;
  TimeGate<Reading> gate_;
  std::deque<Reading> readings_;  ///< none that scans to come could need is missing
  std::deque<Waiting> waiting_;
  models::JumpDetector jumped_;
  std::size_t jumps_ = 0;                   ///< of readings
  std::size_t jumps_served_ = 0;            ///< up to the last scan that was given out
  std::optional<models::SensorStep> last_;  ///< given out, without its scan
  std::size_t scans_ = 0;
  bool finished_ = false;
};

}  // namespace ariadne::io
