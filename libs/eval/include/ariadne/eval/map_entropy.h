// The map term of Eq. (6): cells are independent, so a map's entropy is the sum of its cells'.
#pragma once
#include <cstdint>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::eval {

/// H of one cell, -p ln p - (1 - p) ln(1 - p) in nats, p = 1 / (1 + exp(-log_odds / 16)) as MRPT's
/// cells have it. ln 2 for 0, 0.003 for the most certain cell.
double cellEntropy(std::int8_t log_odds);

/// What a tile adds to the entropy of a map, nats: the sum over its known cells (log odds not 0),
/// so that the entropy grows as the robot sees more. It scales with the number of cells: compare
/// maps of one resolution only.
double tileEntropy(const grid::EvidencePlane::Cells& cells);

}  // namespace ariadne::eval
