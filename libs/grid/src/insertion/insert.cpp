// How one scan enters the grid. Three quarters of a filter's time would go here with a fill ray by
// ray, since beams overlap near the robot; the outline's bits name each cell once.
#include "ariadne/grid/map/occupancy_grid.h"
#include "insertion/scan_raster.h"

namespace ariadne::grid {
namespace {

/// Adds free evidence a few tiles behind the raster: other particles have pushed this one's tiles
/// out of the cache, and meanwhile they come.
class DelayedAddition {
 public:
  DelayedAddition(EvidencePlane& cells, std::vector<CellBox>& freed)
      : cells_(cells), freed_(freed) {}
  void add(int tx, int ty, const TileMask& free) {
    cells_.prefetch(tx, ty);
    if (count_ - done_ == kTiles) addOldest();
    Waiting& waiting = ring_[count_++ % kTiles];
    waiting.tx = tx;
    waiting.ty = ty;
    waiting.free = free;
  }
  void finish() {
    while (done_ < count_) addOldest();
  }

 private:
  static constexpr std::size_t kTiles = 8;
  struct Waiting {
    TileMask free;
    int tx;
    int ty;
  };
  void addOldest() {
    const Waiting& oldest = ring_[done_++ % kTiles];
    cells_.addFree(oldest.tx, oldest.ty, oldest.free, freed_);
  }

  EvidencePlane& cells_;
  std::vector<CellBox>& freed_;
  std::array<Waiting, kTiles> ring_;
  std::size_t count_ = 0;
  std::size_t done_ = 0;
};

/// Buffers that a thread keeps from scan to scan.
struct Scratch {
  ScanRaster raster;
  std::vector<CellBox> freed;
  std::vector<Cell> turned;
};

}  // namespace

void OccupancyGrid::insert(const ScanShape& shape, const mrpt::math::TPose2D& map_from_robot) {
  static thread_local Scratch scratch;
  scratch.raster.build(shape, CellsFromRobot(map_from_robot, origin_, resolution_));
  scratch.freed.clear();
  DelayedAddition addition(cells_, scratch.freed);
  scratch.raster.forEachTile(
      [&](int tx, int ty, const TileMask& free) { addition.add(tx, ty, free); });
  addition.finish();
  scratch.turned.clear();
  cells_.addHits(scratch.raster.hits(), evidence_.occupied, scratch.turned);
  for (const Cell cell : scratch.turned) field_.occupy(cell);
  field_.update(scratch.freed, cells_);
}

}  // namespace ariadne::grid
