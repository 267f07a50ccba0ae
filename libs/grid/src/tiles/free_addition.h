// Evidence for free on its way into one packed tile: what it would change is worked out first,
// since a write may copy the tile.
#pragma once
#include "ariadne/grid/tiles/evidence_tile.h"
#include "tiles/tile_mask.h"

namespace ariadne::grid {

class FreeAddition {
 public:
  /// One beam more for each cell of `free`.
  FreeAddition(const EvidenceTile& tile, const TileMask& free, const FreeCounts& counts);

  bool changesAny() const { return counted_any_ || apart_any_; }
  /// Adds to the tile behind the handle, which must be the one it was made for. Returns the cells
  /// that ceased to be occupied.
  BoxOfBits write(EvidenceTileRef& handle) const;

 private:
  BoxOfBits addApart(EvidenceTile& tile) const;

  const FreeCounts& counts_;
  using Rows = std::array<std::uint32_t, kTileCells>;
  alignas(16) Rows counted_;  // cells whose count goes up
  alignas(16) Rows apart_;    // cells apart whose value does; not set where there are none
  bool counted_any_;
  bool apart_any_;
  int planes_;  // that the counts then need
};

/// Whether all cells are kMostFree.
bool holdsOnlyMostFree(const EvidenceTile& tile, const FreeCounts& counts);

}  // namespace ariadne::grid
