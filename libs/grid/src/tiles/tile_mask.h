// A set of cells of one tile as bits: bit x of word y is cell (x, y). Loops are plain and of fixed
// length, so that the compiler uses lanes.
#pragma once
#include <array>
#include <cstdint>

#include "ariadne/grid/tiles/tiled_plane.h"

namespace ariadne::grid {

struct alignas(16) TileMask {
  std::array<std::uint32_t, kTileCells> rows{};

  bool any() const {
    std::uint32_t all = 0;
    for (const std::uint32_t row : rows) all |= row;
    return all != 0;
  }
  bool full() const {
    std::uint32_t all = ~0U;
    for (const std::uint32_t row : rows) all &= row;
    return all == ~0U;
  }
  bool operator==(const TileMask& other) const { return rows == other.rows; }
};

/// From the cells where an outline is crossed to the cells inside it: each cell becomes the parity
/// of the crossings at or left of it in its row. `left` has all bits of a row set where the tile to
/// the left ended inside; it becomes the same for the tile to the right.
inline TileMask insideOf(const TileMask& crossed, TileMask& left) {
  TileMask inside;
  for (int y = 0; y < kTileCells; ++y) {
    std::uint32_t w = crossed.rows[y];
    w ^= w << 1;
    w ^= w << 2;
    w ^= w << 4;
    w ^= w << 8;
    w ^= w << 16;
    w ^= left.rows[y];
    inside.rows[y] = w;
    left.rows[y] = 0U - (w >> 31);
  }
  return inside;
}

/// Smallest box about the bits of a tile's rows.
class BoxOfBits {
 public:
  /// Rows come in ascending order.
  void add(int y, std::uint32_t row) {
    if (row == 0) return;
    if (columns_ == 0) first_ = y;
    columns_ |= row;
    last_ = y;
  }
  bool empty() const { return columns_ == 0; }
  /// In cells of the map; not for an empty one.
  CellBox inTile(int tx, int ty) const {
    const int x = tx * kTileCells;
    const int y = ty * kTileCells;
    return {x + __builtin_ctz(columns_), y + first_, x + kTileCells - __builtin_clz(columns_),
            y + last_ + 1};
  }

 private:
  std::uint32_t columns_ = 0;
  int first_ = 0;
  int last_ = 0;
};

inline void exclude(TileMask& from, const TileMask& cells) {
  for (int y = 0; y < kTileCells; ++y) from.rows[y] &= ~cells.rows[y];
}

}  // namespace ariadne::grid
