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
  TileFiller(Plane& cells, std::int8_t amount, std::vector<CellBox>& freed)
      : cells_(cells), amount_(amount), lanes_(amount), freed_(freed) {}

  void fill(int tx, int ty, const TileMask& mask) {
    const auto* tile = cells_.tile(tx, ty);
    const bool full = mask.full();
    if (full && fillUniform(tx, ty, tile)) return;
    if (tile) prefetch(tile->data());
    int y = 0;
    if (tile)
      while (y < kTileCells && !lanes_.changes(tile->data() + Plane::offset(0, y), mask.rows[y]))
        ++y;
    if (y == kTileCells) return;
    std::int8_t* out = cells_.writeTile(tx, ty).data();
    BoxOfBits freed;
    for (; y < kTileCells; ++y)
      if (mask.rows[y] != 0) freed.add(y, lanes_.add(out + Plane::offset(0, y), mask.rows[y]));
    if (!freed.empty()) freed_.push_back(freed.inTile(tx, ty));
    if (full && holdsOnly(out, kMostFree)) cells_.setUniform(tx, ty, kMostFree);
  }

 private:
  /// Another particle's tiles have pushed this one out of the cache: all its lines at once.
  static void prefetch(const std::int8_t* tile) {
    constexpr int kCacheLine = 64;
    for (int i = 0; i < kTileCells * kTileCells; i += kCacheLine) __builtin_prefetch(tile + i);
  }
  /// Most tiles that lie wholly inside are uniform: the sum is another one, and no cell is touched.
  bool fillUniform(int tx, int ty, const Plane::Tile* tile) {
    const auto value = tile ? Plane::uniformValue(tile) : std::optional<std::int8_t>(0);
    if (!value || *value < 0) return false;
    const int sum = std::min(*value + amount_, int{kMostFree});
    if (sum != *value) cells_.setUniform(tx, ty, static_cast<std::int8_t>(sum));
    return true;
  }

  Plane& cells_;
  int amount_;
  FreeLanes lanes_;
  std::vector<CellBox>& freed_;  // boxes of cells that ceased to be occupied
};

/// Buffers that a thread keeps from scan to scan.
struct Scratch {
  ScanRaster raster;
  std::vector<CellBox> changed;
};

}  // namespace

void OccupancyGrid::insert(const ScanShape& shape, const mrpt::math::TPose2D& map_from_robot) {
  static thread_local Scratch scratch;
  scratch.raster.build(shape, CellsFromRobot(map_from_robot, origin_, resolution_));
  scratch.changed.clear();
  TileFiller filler(cells_, evidence_.free, scratch.changed);
  scratch.raster.forEachTile(
      [&](int tx, int ty, const TileMask& free) { filler.fill(tx, ty, free); });

  for (const Cell cell : scratch.raster.hits()) {
    const std::int8_t before = at(cell);
    const int after = std::max(before - evidence_.occupied, int{kMostOccupied});
    if (before != after) cells_.set(cell.x, cell.y, static_cast<std::int8_t>(after));
    if (before >= 0 && after < 0) field_.occupy(cell);
  }
  field_.update(scratch.changed, cells_);
}

}  // namespace ariadne::grid
