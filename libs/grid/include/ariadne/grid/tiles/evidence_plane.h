// The log odds of a map: an unbounded plane of packed copy-on-write tiles. Cells nobody wrote are
// 0, unknown.
#pragma once
#include <cstdint>
#include <vector>

#include "ariadne/grid/tiles/evidence_tile.h"

namespace ariadne::grid {

struct TileMask;

/// Indices of a cell: x to the east, y to the north, from cell (0, 0) at the map's origin.
struct Cell {
  int x = 0;
  int y = 0;
};

/// The log odds of all cells, in tiles that maps share until one of them writes.
class EvidencePlane {
 public:
  static constexpr int kRows = kTileCells;  ///< of a tile
  /// Log odds of a tile, row by row.
  using Cells = TileCells<std::int8_t>;

  /// @param free log odds that one beam adds to cells it passes, in [1, 127]
  explicit EvidencePlane(std::int8_t free) : counts_(&FreeCounts::of(free)) {}

  /// Log odds as a cell of COccupancyGridMap2D has them: over 0 free, 0 never seen.
  std::int8_t at(int x, int y) const;
  /// Makes or unshares the tile.
  void set(int x, int y, std::int8_t log_odds);
  /// Takes `occupied` from each of the cells, saturating at kMostOccupied. Appends those that
  /// turned occupied. Quickest where cells of one tile follow each other.
  void addHits(const std::vector<Cell>& cells, std::int8_t occupied, std::vector<Cell>& turned);
  /// Adds the evidence for free once to each of the cells, saturating at kMostFree. The tile is
  /// written to (and perhaps copied) only when a cell of it really changes. Appends the box of the
  /// cells that ceased to be occupied, if any.
  void addFree(int tx, int ty, const TileMask& free, std::vector<CellBox>& freed);

  /// Asks for the tile's memory, which addFree() will want soon.
  void prefetch(int tx, int ty) const;

  /// Tile with tile coordinates (cell >> kTileBits); null where nothing was written. Two planes
  /// that give the same tile hold the same cells there.
  const EvidenceTile* tile(int tx, int ty) const {
    const EvidenceTileRef* handle = tiles_.find(tx, ty);
    return handle ? handle->get() : nullptr;
  }
  /// A tile unpacked to log odds.
  Cells cellsOf(const EvidenceTile& tile) const;
  /// Packs a whole tile. @param tx, ty indices of the tile
  void setCells(int tx, int ty, const Cells& cells);

  /// Box of the tiles that may hold something, in tile coordinates.
  CellBox tileBox() const { return tiles_.tileBox(); }
  /// Calls f(tx, ty, tile) for every tile, row by row.
  template <class F>
  void forEachPacked(F&& f) const {
    const CellBox box = tileBox();
    for (int ty = box.y0; ty < box.y1; ++ty)
      for (int tx = box.x0; tx < box.x1; ++tx)
        if (const EvidenceTile* t = tile(tx, ty)) f(tx, ty, *t);
  }
  /// Calls f(tx, ty, cells) likewise; the cells are gone after the call.
  template <class F>
  void forEachTile(F&& f) const {
    forEachPacked([&](int tx, int ty, const EvidenceTile& t) { f(tx, ty, cellsOf(t)); });
  }
  /// Nothing was ever seen.
  void clear() { tiles_.clear(); }

 private:
  void setIn(EvidenceTileRef& handle, int x, int y, std::int8_t log_odds) const;
  const FreeCounts* counts_;
  TileTable<EvidenceTileRef, kMaxSquareBlocks> tiles_;
};

}  // namespace ariadne::grid
