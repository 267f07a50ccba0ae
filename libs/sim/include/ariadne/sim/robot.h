// The simulated robot as it truly is: MRPT's CVehicleSimul_DiffDriven in a world, and on it a laser
// by COccupancyGridMap2D::laserScanSimulator. No randomness: see Senses for what sensors add.
#pragma once
#include <mrpt/kinematics/CVehicleSimul_DiffDriven.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include "ariadne/models/velocity_command.h"
#include "ariadne/sim/params.h"
#include "ariadne/sim/world.h"

namespace ariadne::sim {

/// MRPT's simulated vehicle with a laser, driven without randomness.
class Robot {
 public:
  /// The world must outlive the robot.
  /// @param start world_from_robot
  /// Throws core::UsageError when a parameter is out of bounds, core::Error when the robot would
  /// touch something at the start.
  Robot(const World& world, const mrpt::math::TPose2D& start, const DriveParams& params);

  /// world_from_robot
  const mrpt::math::TPose2D& pose() const { return vehicle_.getCurrentGTPose(); }
  /// Since the start of the simulation, s.
  double time_s() const { return time_s_; }

  /// Follows the command until `time_s`, since the start. Returns false when that took it into
  /// rock or glass: it then stands where it stood before.
  bool moveUntil(double time_s, const models::VelocityCommand& command);
  /// What the laser, without noise, sees now.
  mrpt::obs::CObservation2DRangeScan::Ptr scan() const;

 private:
  bool touches() const;

  const World& world_;
  DriveParams params_;
  mrpt::kinematics::CVehicleSimul_DiffDriven vehicle_;
  double time_s_ = 0;
};

}  // namespace ariadne::sim
