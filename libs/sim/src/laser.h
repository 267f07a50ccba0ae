// The laser of the simulated robot.
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include "ariadne/sim/params.h"
#include "ariadne/sim/world.h"

namespace ariadne::sim {

/// What it sees from a pose (world_from_robot), without noise.
mrpt::obs::CObservation2DRangeScan::Ptr scanFrom(const World& world,
                                                 const mrpt::math::TPose2D& pose,
                                                 const DriveParams& params);

}  // namespace ariadne::sim
