// MRPT's simple map, scans with their poses: a grid from one, and one from a particle's line.
#pragma once
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

#include "ariadne/filter/ancestry.h"
#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::slam {

/// Every scan of the simple map at the mean of its pose.
grid::OccupancyGrid gridOf(const mrpt::maps::CSimpleMap& known, const grid::GridParams& params);
/// What was known, then the scans of the line.
/// @param scans one per update of the line
mrpt::maps::CSimpleMap simpleMapOf(
    const mrpt::maps::CSimpleMap& known,
    const std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>& scans,
    const filter::AncestorPtr& leaf);

}  // namespace ariadne::slam
