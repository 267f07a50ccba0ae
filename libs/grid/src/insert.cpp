// How one scan enters the grid. Three quarters of a filter's time would go here with a fill ray by
// ray, since beams overlap near the robot; the outline's bits name each cell once.
#include <algorithm>

#include "ariadne/grid/occupancy_grid.h"
#include "row_lanes.h"
#include "scan_raster.h"

namespace ariadne::grid {
namespace {

using Plane = TiledPlane<std::int8_t>;

/// Adds evidence for free to one tile after the other. A tile is asked for writing (and perhaps
/// copied) only when a cell of it really changes.
class TileFiller {
 public:
  TileFiller(Plane& cells, std::int8_t amount, std::vector<Cell>& freed)
      : cells_(cells), amount_(amount), lanes_(amount), freed_(freed) {}

  void fill(int tx, int ty, const TileMask& mask) {
    const auto* tile = cells_.tile(tx, ty);
    const bool full = mask.full();
    if (full && fillUniform(tx, ty, tile)) return;
    int y = 0;
    if (tile)
      while (y < kTileCells && !lanes_.changes(tile->data() + y * kTileCells, mask.rows[y])) ++y;
    if (y == kTileCells) return;
    std::int8_t* out = cells_.writeTile(tx, ty).data();
    for (; y < kTileCells; ++y) {
      if (mask.rows[y] == 0) continue;
      std::uint32_t freed = lanes_.add(out + y * kTileCells, mask.rows[y]);
      for (; freed != 0; freed &= freed - 1)
        freed_.push_back({tx * kTileCells + __builtin_ctz(freed), ty * kTileCells + y});
    }
    if (full && allMostFree(out)) cells_.setUniform(tx, ty, kMostFree);
  }

 private:
  /// Most tiles that lie wholly inside are uniform: the sum is another one, and no cell is touched.
  bool fillUniform(int tx, int ty, const Plane::Tile* tile) {
    const auto value = tile ? Plane::uniformValue(tile) : std::optional<std::int8_t>(0);
    if (!value || *value < 0) return false;
    const int sum = std::min(*value + amount_, int{kMostFree});
    if (sum != *value) cells_.setUniform(tx, ty, static_cast<std::int8_t>(sum));
    return true;
  }
  static bool allMostFree(const std::int8_t* tile) {
    int y = 0;
    while (y < kTileCells && allAre(tile + y * kTileCells, kMostFree)) ++y;
    return y == kTileCells;
  }

  Plane& cells_;
  int amount_;
  FreeLanes lanes_;
  std::vector<Cell>& freed_;
};

/// Buffers that a thread keeps from scan to scan.
struct Scratch {
  ScanRaster raster;
  std::vector<Cell> freed;
};

}  // namespace

void OccupancyGrid::insert(const ScanShape& shape, const mrpt::math::TPose2D& map_from_robot) {
  static thread_local Scratch scratch;
  scratch.raster.build(shape, CellsFromRobot(map_from_robot, origin_, resolution_));
  scratch.freed.clear();
  TileFiller filler(cells_, evidence_.free, scratch.freed);
  scratch.raster.forEachTile(
      [&](int tx, int ty, const TileMask& free) { filler.fill(tx, ty, free); });

  for (const Cell cell : scratch.raster.hits()) {
    const std::int8_t before = at(cell);
    const int after = std::max(before - evidence_.occupied, int{kMostOccupied});
    if (before != after) cells_.set(cell.x, cell.y, static_cast<std::int8_t>(after));
    if (before >= 0 && after < 0) field_.occupy(cell);
  }
  for (const Cell cell : scratch.freed) field_.release(cell, cells_);
}

}  // namespace ariadne::grid
