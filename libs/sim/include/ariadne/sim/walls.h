// The walls of a world, as far as the laser of a drive met them.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <vector>

#include "ariadne/geometry/trajectory.h"
#include "ariadne/sim/params.h"
#include "ariadne/sim/world.h"

namespace ariadne::sim {

/// Moments at which the robot has moved or turned since the one before (0.2 m, 10 degrees): what
/// it saw in between it sees there, too. Indices in the path, from the first.
std::vector<std::size_t> keyMoments(const geometry::Trajectory& path);

/// Centres of the world's cells in which a beam ended in rock, each once, in the order they were
/// hit; frame of the world, m. Rays are cast through the world itself, from the key moments: a wall
/// stays where one beam met it, however many passed by. A cell lies up to one behind the wall's
/// face, see drive.h.
/// @param truth world_from_robot
/// @param params field of view, beams and range of the laser
std::vector<mrpt::math::TPoint2D> wallsHit(const World& world, const geometry::Trajectory& truth,
                                           const DriveParams& params);

}  // namespace ariadne::sim
