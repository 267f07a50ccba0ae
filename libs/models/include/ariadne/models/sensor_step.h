// One scan with the odometry at its time: all that the filter ever sees of a dataset or a robot.
#pragma once
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

namespace ariadne::models {

/// What the filter takes at a time: where the odometry says that the robot is, and a scan.
struct SensorStep {
  double time_s = 0;                    ///< UNIX time of the scan, seconds
  mrpt::math::TPose2D odom_from_robot;  ///< cumulative odometry, m and rad
  /// The scan; null where a dataset has odometry only. sensorPose is robot_from_laser.
  mrpt::obs::CObservation2DRangeScan::Ptr scan;
  /// The motion from the step before is none that a robot makes: odometry was reset, or the robot
  /// was carried. What follows goes on from here.
  bool odometry_jumped = false;
};

}  // namespace ariadne::models
