// The last word on a command is the scan's: whatever the map says, the robot does not drive into
// what its laser sees.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

#include "ariadne/explore/params.h"

namespace ariadne::explore {

/// Ends of the beams that hit something within `range_m`, m, frame of the robot.
std::vector<mrpt::math::TPoint2D> hitsOf(const mrpt::obs::CObservation2DRangeScan& scan,
                                         double range_m);

/// Whether one of the beams' ends lies where the robot's disc is within the next `ahead_m` m.
bool blocked(const std::vector<mrpt::math::TPoint2D>& hits, double ahead_m,
             const ExploreParams& params);

}  // namespace ariadne::explore
