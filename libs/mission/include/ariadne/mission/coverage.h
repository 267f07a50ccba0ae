// How much of a world was explored, by the truth: whether the map is right is another question.
#pragma once
#include <vector>

#include "ariadne/geometry/trajectory.h"
#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/models/sensor_step.h"
#include "ariadne/sim/params.h"
#include "ariadne/sim/world.h"

namespace ariadne::mission {

/// What a laser of the robot's range, without noise and all around, sees from places half a metre
/// apart wherever the robot's disc can get to from the start. Frame of the world.
/// Throws core::Error when the robot cannot stand at the start.
grid::OccupancyGrid seeable(const sim::World& world, const mrpt::math::TPose2D& start,
                            const sim::DriveParams& params, double resolution_m);

/// What the robot's scans saw from where it truly was. Frame of the world.
/// @param truth world_from_robot, one a step
grid::OccupancyGrid sighted(const std::vector<models::SensorStep>& steps,
                            const geometry::Trajectory& truth, double resolution_m);

/// Share of the cells of floor that are free in `seeable` which are known in `sighted`, 0 to 1;
/// both have the same resolution. Beams at grazing angles end behind the wall's face: what they
/// clear there does not count. 1 when there is no such cell.
double coverage(const sim::World& world, const grid::OccupancyGrid& seeable,
                const grid::OccupancyGrid& sighted);

}  // namespace ariadne::mission
