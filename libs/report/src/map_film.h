// Maps as tables of tiles, one after the other. A map is held until the next one comes: its tiles
// are copy-on-write, so that a tile at the same address has not changed and is not drawn again.
#pragma once
#include <unordered_map>
#include <vector>

#include "ariadne/grid/occupancy_grid.h"
#include "tile_store.h"

namespace ariadne::report {

class MapFilm {
 public:
  /// The map's tiles, row by row from the south; those of unknown cells left out.
  std::vector<PlacedTile> take(const grid::OccupancyGrid& map, TileStore& store);
  /// From now on 2^level x 2^level cells are one pixel, and no tile is known from before: to be
  /// called also when the store was renumbered.
  void restart(int level);
  int level() const { return level_; }

 private:
  bool unchanged(const grid::OccupancyGrid& map, int x, int y) const;
  ReplayTile draw(const grid::OccupancyGrid& map, int x, int y) const;

  int level_ = 0;
  grid::OccupancyGrid before_;
  std::unordered_map<std::int64_t, std::uint32_t> drawn_;  // of `before_`, by place
};

/// Longer side of the box around the tiles, pixels.
int sideOf(const std::vector<PlacedTile>& map);

/// The same maps with 2 x 2 pixels made one; as if drawn at the next level.
void halve(std::vector<ReplayFrame>& frames, TileStore& store);

}  // namespace ariadne::report
