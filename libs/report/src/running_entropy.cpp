#include "running_entropy.h"

#include <numeric>

#include "ariadne/eval/map_entropy.h"

namespace ariadne::report {

double RunningEntropy::of(const grid::OccupancyGrid& map) {
  const grid::CellBox box = map.cells().tileBox();
  const auto known = [&](int x, int y) -> const double* {
    if (x < box_.x0 || x >= box_.x1 || y < box_.y0 || y >= box_.y1) return nullptr;
    return &tiles_[static_cast<std::size_t>(y - box_.y0) * (box_.x1 - box_.x0) + (x - box_.x0)];
  };
  std::vector<double> tiles;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) {
      const auto* tile = map.cells().tile(x, y);
      const double* before = known(x, y);
      if (before && tile == before_.cells().tile(x, y))
        tiles.push_back(*before);
      else
        tiles.push_back(tile ? eval::tileEntropy(map.cells().cellsOf(*tile)) : 0);
    }
  before_ = map;
  box_ = box;
  tiles_ = std::move(tiles);
  return std::accumulate(tiles_.begin(), tiles_.end(), 0.0);
}

}  // namespace ariadne::report
