// The map term of Eq. (6): cells are independent, so a map's entropy is the sum of its cells'.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "ariadne/grid/occupancy_grid.h"

namespace ariadne::eval {

/// H of one cell, -p ln p - (1 - p) ln(1 - p) in nats, p = 1 / (1 + exp(-log_odds / 16)) as MRPT's
/// cells have it. ln 2 for 0, 0.003 for the most certain cell.
double cellEntropy(std::int8_t log_odds);

/// Which cells count. Without a box: the known ones (log odds not 0), so that the entropy grows as
/// the robot sees more. With a box, in cells: every cell in it and none outside, an unknown one
/// with ln 2; so maps of different extent compare, and exploring lowers the entropy.
struct CountedCells {
  std::optional<grid::CellBox> box;
};

/// Entropy of a map, nats. It scales with the number of cells: compare maps of one resolution only.
double mapEntropy(const grid::OccupancyGrid& map, const CountedCells& cells = {});

/// The part of mapEntropy() (without a box) that one tile makes: for sums that are kept up to date
/// tile by tile.
double tileEntropy(const grid::EvidencePlane::Cells& cells);

/// As mapEntropy() for each (not null); tiles that the maps share are summed once.
std::vector<double> mapEntropies(const std::vector<const grid::OccupancyGrid*>& maps,
                                 const CountedCells& cells = {});

}  // namespace ariadne::eval
