#include "ariadne/grid/tiles/log_odds.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>

namespace ariadne::grid {

using mrpt::maps::COccupancyGridMap2D;

BeamEvidence beamEvidence(const GridParams& params) {
  const auto steps = [](double probability) {
    const int l = COccupancyGridMap2D::p2l(static_cast<float>(probability));
    return static_cast<std::int8_t>(std::clamp(l, 1, 127));
  };
  return {steps(params.free_probability), steps(params.occupied_probability)};
}

float freeProbability(std::int8_t log_odds) { return COccupancyGridMap2D::l2p(log_odds); }

}  // namespace ariadne::grid
