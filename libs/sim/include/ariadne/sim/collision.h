// Whether a disc stands on floor only.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

namespace ariadne::sim {

/// True if a cell of rock reaches into the disc (metres); beyond the map all is rock.
bool touchesRock(const mrpt::maps::COccupancyGridMap2D& map, double x, double y, double radius);

}  // namespace ariadne::sim
