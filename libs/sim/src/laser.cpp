#include "laser.h"

#include <mrpt/poses/CPose2D.h>

#include <cmath>

namespace ariadne::sim {

mrpt::obs::CObservation2DRangeScan::Ptr scanFrom(const World& world,
                                                 const mrpt::math::TPose2D& pose,
                                                 const DriveParams& params) {
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->sensorLabel = "laser";
  scan->aperture = static_cast<float>(params.field_of_view_deg * M_PI / 180);
  scan->rightToLeft = true;
  scan->maxRange = static_cast<float>(params.max_range_m);
  world.map.laserScanSimulator(*scan, mrpt::poses::CPose2D(pose), 0.5F,
                               static_cast<std::size_t>(params.beams));
  // MRPT 2.5.8 gives a beam without return 0.8 of the maximum range.
  for (std::size_t i = 0; i < scan->getScanSize(); ++i)
    if (!scan->getScanRangeValidity(i)) scan->setScanRange(i, scan->maxRange);
  return scan;
}

}  // namespace ariadne::sim
