// A scan in the robot's frame, prepared once a step to enter the map of every particle: the
// outline of what it saw free, and the points where beams ended.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

#include "ariadne/grid/params.h"

namespace ariadne::grid {

/// What a scan says about cells, before it is laid into a map.
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

/// True where under `least_returns` of the beams ended within the insertion range, so that the scan
/// tells nothing. Where beams without return clear the map, even an empty scan tells something.
bool isBlind(const mrpt::obs::CObservation2DRangeScan& scan, const GridParams& params,
             double least_returns);

/// Under this share of returns a scan's ends of walls are left out of matching.
constexpr double kFewReturns = 0.4;

/// The points that a scan is matched by: as scanPoints(), but where under the share `few` of the
/// beams returned without the last 0.5 m of walls that the laser's reach cuts off (no return next
/// to a reading of over 80 % of maxRange). Such an end moves along with the robot; with few other
/// beams, matching it to the end of the mapped wall would hold the robot back.
std::vector<mrpt::math::TPoint2D> scanFeatures(const mrpt::obs::CObservation2DRangeScan& scan,
                                               double max_range_m, double few = kFewReturns);

}  // namespace ariadne::grid
