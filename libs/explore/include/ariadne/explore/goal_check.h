// Whether a goal and the route there still stand, by a look at the map beside them: much cheaper
// than to decide anew.
#pragma once
#include "ariadne/explore/planner.h"

namespace ariadne::explore {

/// Whether the robot is on its route, and for the next metres the map knows no wall in it.
/// @param next first point of the route that is not behind the robot
bool routeHolds(const grid::OccupancyGrid& map, const Route& route, std::size_t next,
                const mrpt::math::TPose2D& map_from_robot, const ExploreParams& params);

/// Whether the map does not know a few cells within `reach_m` of the point.
bool bordersUnknown(const grid::OccupancyGrid& map, const mrpt::math::TPoint2D& point,
                    double reach_m);

/// Area that the map knows to be free within `reach_m` of the point, m^2.
double freeArea(const grid::OccupancyGrid& map, const mrpt::math::TPoint2D& point, double reach_m);

}  // namespace ariadne::explore
