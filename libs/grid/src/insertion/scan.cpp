#include "ariadne/grid/insertion/scan.h"

#include <utility>

#include "ariadne/grid/field/endpoint_likelihood.h"
#include "insertion/scan_returns.h"

namespace ariadne::grid {

Scan takeScan(mrpt::obs::CObservation2DRangeScan::Ptr raw, const GridParams& params,
              std::size_t most_features) {
  Scan scan;
  ScanReturns returns = returnsOf(*raw, params.insert_range_m);
  scan.shape.outline = outlineOf(*raw, params);
  scan.features = thinned(featuresOf(*raw, returns, kFewReturns), most_features);
  scan.walls = wallDirections(returns.points, returns.beams);
  if (!scan.shape.outline.empty()) {
    scan.shape.hits = std::move(returns.points);
    scan.beams = std::move(returns.beams);
  }
  scan.raw = std::move(raw);
  return scan;
}

std::vector<mrpt::math::TPoint2D> Scan::hitsWithin(double range_m) const {
  std::vector<mrpt::math::TPoint2D> near;
  for (std::size_t k = 0; k < beams.size(); ++k)
    if (raw->getScanRange(beams[k]) < range_m) near.push_back(shape.hits[k]);
  return near;
}

}  // namespace ariadne::grid
