// Maps as tables of tiles, one after the other. A map is held until the next one comes: its tiles
// are copy-on-write, so that a tile at the same address has not changed and is not drawn again.
#pragma once
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"
#include "tile_store.h"

namespace ariadne::report {

class MapFilm {
 public:
  /// The map's tiles, row by row from the south; none of unknown pixels only.
  std::vector<PlacedTile> take(const grid::OccupancyGrid& map, TileStore& store);
  /// From now on 2^level x 2^level cells are one pixel, and no tile is known from before: to be
  /// called also when the store was renumbered.
  void restart(int level);
  int level() const { return level_; }

 private:
  std::uint32_t numberBefore(int x, int y) const;
  std::uint32_t draw(const grid::OccupancyGrid& map, int x, int y, TileStore& store) const;

  int level_ = 0;
  grid::OccupancyGrid before_;
  grid::CellBox box_;                   // of places, that were drawn of `before_`
  std::vector<std::uint32_t> numbers_;  // of their tiles, row by row
};

}  // namespace ariadne::report
