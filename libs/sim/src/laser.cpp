#include "laser.h"

#include <mrpt/poses/CPose2D.h>

#include <cmath>

namespace ariadne::sim {
namespace {

/// MRPT 2.5.8 goes along a ray by steps of 0.8 cells, and as many of them as the maximum range has
/// cells: it is asked for more, so that walls are seen up to the range.
constexpr double kStepInCells = 0.8;

}  // namespace

mrpt::obs::CObservation2DRangeScan::Ptr scanFrom(const World& world,
                                                 const mrpt::math::TPose2D& pose,
                                                 const DriveParams& params) {
  const auto max_range_m = static_cast<float>(params.max_range_m);
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->sensorLabel = "laser";
  scan->aperture = static_cast<float>(params.field_of_view_deg * M_PI / 180);
  scan->rightToLeft = true;
  scan->maxRange = static_cast<float>(params.max_range_m / kStepInCells);
  world.map.laserScanSimulator(*scan, mrpt::poses::CPose2D(pose), 0.5F,
                               static_cast<std::size_t>(params.beams));
  scan->maxRange = max_range_m;
  for (std::size_t i = 0; i < scan->getScanSize(); ++i) {
    if (scan->getScanRangeValidity(i) && scan->getScanRange(i) < max_range_m) continue;
    scan->setScanRangeValidity(i, false);
    scan->setScanRange(i, max_range_m);
  }
  return scan;
}

}  // namespace ariadne::sim
