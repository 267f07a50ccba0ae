// What a log's steps come to, gathered as they pass: what a result is judged against.
#pragma once
#include <cstddef>
#include <optional>

#include "ariadne/models/scan_odometry.h"
#include "ariadne/models/sensor_step.h"

namespace ariadne::checks {

/// What the steps of a log show of its sensors.
struct DriveFigures {
  std::size_t scans = 0;
  std::size_t blind_scans = 0;     ///< hardly a beam returned
  std::size_t standing_scans = 0;  ///< by the scans the robot drove, while the odometry stood still
  double odometry_m = 0;           ///< length, without the jumps
};

/// Counts DriveFigures while the steps pass.
class DriveWatch {
 public:
  /// @param least_returns of grid::isBlind()
  DriveWatch(const grid::GridParams& grid, double least_returns)
      : grid_(grid), least_returns_(least_returns) {}

  /// The next step, with or without a scan.
  void add(const models::SensorStep& step);
  /// Of all steps that were added.
  const DriveFigures& figures() const { return figures_; }

 private:
  void stand(const models::SensorStep& step);

  grid::GridParams grid_;
  double least_returns_;
  DriveFigures figures_;
  mrpt::math::TPose2D last_;                      // odometry of the step before
  mrpt::math::TPose2D stand_;                     // odometry where it last moved to
  std::size_t still_ = 0;                         // scans since
  std::optional<models::ScanOdometry> by_scans_;  // of the robot while its odometry stands
};

}  // namespace ariadne::checks
