// Cells hold log odds as MRPT's COccupancyGridMap2D does: int8 from -127 (occupied) over 0
// (unknown) to 127 (free), 16 steps to the natural logarithm.
#pragma once
#include <cstdint>

#include "ariadne/grid/params.h"

namespace ariadne::grid {

constexpr std::int8_t kMostFree = 127;
constexpr std::int8_t kMostOccupied = -127;

/// What one beam adds to the cells it passes, and takes from the one it ends in; both positive.
struct BeamEvidence {
  std::int8_t free = 0;
  std::int8_t occupied = 0;
};

/// By the probabilities of [grid], rounded to whole log odds, at least 1.
BeamEvidence beamEvidence(const GridParams& params);

/// Probability that a cell is free; the table of MRPT's COccupancyGridMap2D::l2p.
float freeProbability(std::int8_t log_odds);

}  // namespace ariadne::grid
