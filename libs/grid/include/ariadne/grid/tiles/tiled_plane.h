// An unbounded plane of one-byte cells in copy-on-write tiles. Cells nobody wrote are 0.
#pragma once
#include <array>
#include <cstdint>

#include "ariadne/grid/tiles/tile_table.h"

namespace ariadne::grid {

/// Cells of a tile, row by row.
template <class T>
using TileCells = std::array<T, kTileCells * kTileCells>;

/// Cell (x, y)'s place in its tile.
constexpr int tileOffset(int x, int y) {
  return ((y & (kTileCells - 1)) << kTileBits) | (x & (kTileCells - 1));
}

/// T is std::int8_t or std::uint8_t. Tiles are kTileCells wide and kRows high.
template <class T, int RowBits = kTileBits>
class TiledPlane {
 public:
  static constexpr int kRowBits = RowBits;
  static constexpr int kRows = 1 << RowBits;
  /// kTileCells x kRows values, row by row from the south.
  using Tile = std::array<T, kTileCells * kRows>;

  /// Cell (x, y)'s place in its tile.
  static constexpr int offset(int x, int y) {
    return ((y & (kRows - 1)) << kTileBits) | (x & (kTileCells - 1));
  }

  /// The value of a cell; T{} where no tile is.
  T at(int x, int y) const {
    const Tile* t = tile(x >> kTileBits, y >> RowBits);
    return t ? (*t)[offset(x, y)] : T{0};
  }
  /// Makes or unshares the cell's tile.
  void set(int x, int y, T value) { writeTile(x >> kTileBits, y >> RowBits)[offset(x, y)] = value; }

  /// Tile with tile coordinates (x >> kTileBits, y >> RowBits); null where nothing was written.
  const Tile* tile(int tx, int ty) const {
    const Cow<Tile>* handle = tiles_.find(tx, ty);
    return handle ? handle->get() : nullptr;
  }
  /// Tile for writing; made when missing, copied when shared. Throws core::Error when the plane
  /// would grow past all bounds.
  Tile& writeTile(int tx, int ty) { return tiles_.at(tx, ty).write(); }

  /// Box of the tiles that may hold something, in tile coordinates.
  CellBox tileBox() const { return tiles_.tileBox(); }
  /// Calls f(tx, ty, tile) for every tile, row by row.
  template <class F>
  void forEachTile(F&& f) const {
    const CellBox box = tileBox();
    for (int ty = box.y0; ty < box.y1; ++ty)
      for (int tx = box.x0; tx < box.x1; ++tx)
        if (const Tile* t = tile(tx, ty)) f(tx, ty, *t);
  }
  /// T{} everywhere.
  void clear() { tiles_.clear(); }

 private:
  TileTable<Cow<Tile>, kMaxSquareBlocks * kTileCells / kRows> tiles_;
};

}  // namespace ariadne::grid
