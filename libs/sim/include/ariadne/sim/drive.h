// Simulated drives. What truly happens has no randomness in it: a world, a path and parameters give
// the same drive always. Sensor noise comes afterwards and is cheap, so that an experiment drives
// once and observes once a seed.
//
// The robot is MRPT's CVehicleSimul_DiffDriven, the laser COccupancyGridMap2D::laserScanSimulator,
// which goes along a ray by steps of 0.8 cells: the end of a beam lies up to a cell behind the face
// of the wall.
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ariadne/geometry/trajectory.h"
#include "ariadne/models/sensor_step.h"
#include "ariadne/sim/drive_path.h"
#include "ariadne/sim/params.h"
#include "ariadne/sim/world.h"

namespace ariadne::sim {

/// When the drive came by a mark of its path.
struct MarkTime {
  std::string name;
  double time_s = 0;  ///< since the start of the drive
};

/// The world as it was: poses (world_from_robot) and noiseless scans, one of each a scan time, at
/// 0, 1 / rate, 2 / rate, ... seconds until the first after the last waypoint is reached. Read
/// only, so that threads may observe one drive.
struct TruthDrive {
  geometry::Trajectory poses;
  std::vector<mrpt::obs::CObservation2DRangeScan::ConstPtr> scans;
  std::vector<MarkTime> marks;
};

/// Told how much is driven, 0 to 1.
using DriveProgress = std::function<void(double fraction)>;

/// Drives through all waypoints; one counts as passed within 0.3 m.
/// Throws core::Error naming world, time, pose and the last waypoint (file and line) when the robot
/// touches rock or needs much longer to the next waypoint than driving there takes, UsageError when
/// a parameter is out of bounds.
TruthDrive driveThrough(const World& world, const DrivePath& path, const DriveParams& params,
                        const DriveProgress& progress = {});

/// A drive as the robot's sensors saw it, with the truth.
struct SimulatedDrive {
  std::vector<models::SensorStep> steps;  ///< odometry starts at the origin
  geometry::Trajectory truth;             ///< world_from_robot at each step
  std::vector<MarkTime> marks;
};

/// What the robot's sensors say of the drive. The k-th step's draws depend on (seed, k) only: same
/// seed, same bits. A beam that noise takes beyond the maximum range has no return. Throws
/// UsageError when a parameter is out of bounds.
SimulatedDrive observe(const TruthDrive& drive, const NoiseParams& noise, std::uint64_t seed);

}  // namespace ariadne::sim
