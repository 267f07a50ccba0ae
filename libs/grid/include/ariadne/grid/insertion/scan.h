// A scan in all the forms that an update of the filter needs, made once, where it comes in.
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

#include "ariadne/grid/insertion/scan_shape.h"
#include "ariadne/grid/insertion/wall_directions.h"

namespace ariadne::grid {

/// One scan, as it was recorded and as maps and matching take it.
struct Scan {
  mrpt::obs::CObservation2DRangeScan::Ptr raw;  ///< as it was recorded
  ScanShape shape;                              ///< by which it enters maps
  std::vector<std::size_t> beams;               ///< of each of shape.hits
  std::vector<mrpt::math::TPoint2D> features;   ///< by which it is matched: scanFeatures()
  WallDirections walls;                         ///< of all its ends

  /// Those of shape.hits with a reading under `range_m`, m, robot's frame.
  std::vector<mrpt::math::TPoint2D> hitsWithin(double range_m) const;
};

/// @param most_features they are thinned to this number, see thinned()
Scan takeScan(mrpt::obs::CObservation2DRangeScan::Ptr raw, const GridParams& params,
              std::size_t most_features);

}  // namespace ariadne::grid
