// A scan in the robot's frame, prepared once a step to enter the map of every particle: the
// outline of what it saw free, and the points where beams ended.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

#include "ariadne/grid/params.h"

namespace ariadne::grid {

struct ScanShape {
  /// Closed polygon, m, robot's frame: the area between the laser and its readings, each shortened
  /// by one cell so that walls are not cleared.
  std::vector<mrpt::math::TPoint2D> outline;
  /// Ends of the beams that returned within the insertion range, m, robot's frame.
  std::vector<mrpt::math::TPoint2D> hits;
};

/// Laser pose (also off-centre or upside down) and beam order are taken from the scan. Invalid
/// beams clear nothing, but those at or past maxRange clear up to `no_return_free_m`.
ScanShape makeScanShape(const mrpt::obs::CObservation2DRangeScan& scan, const GridParams& params);

/// Ends of all beams that returned within (0, max_range_m), m, robot's frame, in beam order.
std::vector<mrpt::math::TPoint2D> scanPoints(const mrpt::obs::CObservation2DRangeScan& scan,
                                             double max_range_m);

}  // namespace ariadne::grid
