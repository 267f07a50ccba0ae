// The parts of a scan's forms, so that each beam is turned into a point once.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

#include "ariadne/grid/params.h"

namespace ariadne::grid {

struct ScanReturns {
  std::vector<mrpt::math::TPoint2D> points;  ///< ends of beams, m, robot's frame
  std::vector<std::size_t> beams;            ///< of each
};

/// Of the beams that returned within (0, max_range_m), in their order.
ScanReturns returnsOf(const mrpt::obs::CObservation2DRangeScan& scan, double max_range_m);

/// ScanShape::outline.
std::vector<mrpt::math::TPoint2D> outlineOf(const mrpt::obs::CObservation2DRangeScan& scan,
                                            const GridParams& params);

/// scanFeatures() of these returns.
std::vector<mrpt::math::TPoint2D> featuresOf(const mrpt::obs::CObservation2DRangeScan& scan,
                                             const ScanReturns& returns, double few);

}  // namespace ariadne::grid
