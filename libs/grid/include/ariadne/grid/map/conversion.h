// To and from MRPT's COccupancyGridMap2D, exact cell by cell.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::grid {

/// The box of known cells (one unknown cell where nothing is known), in the same place: cell (x, y)
/// of ours is cell (x - box.x0, y - box.y0) of MRPT's. Throws core::Error when MRPT's dense grid
/// would take over 4 GB.
mrpt::maps::COccupancyGridMap2D toMrpt(const OccupancyGrid& grid);

/// Takes every cell of MRPT's grid, its resolution and its place. `params` gives the evidence and
/// the field's width for what is inserted later. Throws core::UsageError when the resolution is out
/// of the bounds of GridParams.
OccupancyGrid fromMrpt(const mrpt::maps::COccupancyGridMap2D& grid, GridParams params = {});

}  // namespace ariadne::grid
