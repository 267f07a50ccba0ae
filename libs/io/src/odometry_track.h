// Where the odometry has the robot at a scan's time, whichever way the log says it.
#pragma once
#include <deque>
#include <optional>
#include <string>

#include "ariadne/io/dataset.h"
#include "ariadne/io/dataset_records.h"
#include "time_gate.h"

namespace ariadne::io {

/// Scans go in, steps come out, in the same order. Increments are added up; readings are
/// interpolated, so a scan waits for the reading after it. The kind of odometry that is met first
/// is the one that is used.
class OdometryTrack {
 public:
  explicit OdometryTrack(DatasetCounts& counts) : counts_(counts) {}

  void add(const OdometryIncrement& increment);
  void add(const OdometryReading& reading);
  /// A scan and the pose that increments or its own line give it; it waits for a better one where
  /// readings are used.
  void add(models::SensorStep step) { waiting_.push_back(std::move(step)); }
  /// The pose of a scan that comes now; `line_pose` where its record has one. False: not possible.
  bool poseOfScan(const std::optional<mrpt::math::TPose2D>& line_pose, mrpt::math::TPose2D& pose);
  /// Nothing more will come: waiting scans take the last reading.
  void finish();
  std::optional<models::SensorStep> pop();
  bool hasOdometry() const { return kind_ != Kind::unknown; }
  std::size_t waiting() const { return waiting_.size(); }

 private:
  enum class Kind { unknown, increments, readings, lines };
  bool useKind(Kind kind);
  void takeReadings();
  bool locate(models::SensorStep& step);

  DatasetCounts& counts_;
  Kind kind_ = Kind::unknown;
  mrpt::math::TPose2D sum_;
  std::optional<std::string> label_;
  TimeGate<mrpt::math::TPose2D> gate_;
  std::deque<std::pair<double, mrpt::math::TPose2D>> readings_;
  std::deque<models::SensorStep> waiting_;
  std::optional<double> served_s_;  ///< scans to come are not before it
  bool finished_ = false;
};

}  // namespace ariadne::io
