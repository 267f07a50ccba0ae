// Where a robot can truly get to.
#pragma once
#include <vector>

#include "ariadne/sim/world.h"

namespace ariadne::mission {

/// Places that the robot's disc can get to from the start without touching anything, m, frame of
/// the world; the start is the first. Paths are looked for on the world's own cells.
/// @param apart_m there is one in each square of this side
/// Throws core::Error when the robot cannot stand at the start.
std::vector<mrpt::math::TPoint2D> reachablePlaces(const sim::World& world,
                                                  const mrpt::math::TPose2D& start,
                                                  double robot_radius_m, double apart_m);

}  // namespace ariadne::mission
