// The entropy of one map after the other, where each differs little from the one before.
#pragma once
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::report {

class RunningEntropy {
 public:
  /// Sum of eval::cellEntropy() over the known cells, nats; only tiles that changed since the last
  /// map are summed anew.
  double of(const grid::OccupancyGrid& map);

 private:
  grid::OccupancyGrid before_;  // held, so that a tile at the same address has not changed
  grid::CellBox box_;           // of tiles
  std::vector<double> tiles_;   // of `before_`, row by row
};

}  // namespace ariadne::report
