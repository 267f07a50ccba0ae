// An unbounded plane of one-byte cells in copy-on-write tiles, behind a table of two levels: a
// rectangle of blocks, each 16 x 16 tiles of 32 x 32 cells. Cells nobody wrote are 0.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ariadne/grid/cow.h"

namespace ariadne::grid {

constexpr int kTileBits = 5;
constexpr int kTileCells = 1 << kTileBits;  ///< side of a tile, cells
constexpr int kBlockBits = 4;
constexpr int kBlockTiles = 1 << kBlockBits;  ///< side of a block, tiles

/// Half-open rectangle of cells (or tiles); empty when x0 >= x1.
struct CellBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

/// T is std::int8_t or std::uint8_t.
template <class T>
class TiledPlane {
 public:
  /// Cells of a tile, row by row.
  using Tile = std::array<T, kTileCells * kTileCells>;

  T at(int x, int y) const {
    const Tile* t = tile(x >> kTileBits, y >> kTileBits);
    return t ? (*t)[offset(x, y)] : T{0};
  }
  void set(int x, int y, T value) {
    writeTile(x >> kTileBits, y >> kTileBits)[offset(x, y)] = value;
  }

  /// Tile with tile coordinates (cell >> kTileBits); null where nothing was written.
  const Tile* tile(int tx, int ty) const {
    const Block* b = block(tx >> kBlockBits, ty >> kBlockBits);
    return b ? (*b)[slot(tx, ty)].get() : nullptr;
  }
  /// Tile for writing; made when missing, copied when shared. Throws core::Error when the plane
  /// would span more than kMaxBlocks.
  Tile& writeTile(int tx, int ty);
  /// Gives the tile new cells, all of them; throws as writeTile() does.
  void setTile(int tx, int ty, const Tile& cells);
  /// Makes the tile one of uniform value, which all planes share and which takes no memory.
  void setUniform(int tx, int ty, T value);
  /// The value of a tile that setUniform() made; nothing for any other, whatever its cells hold.
  static std::optional<T> uniformValue(const Tile* tile);

  /// Box of the tiles that may hold something, in tile coordinates.
  CellBox tileBox() const;
  /// Calls f(tx, ty, tile) for every tile, row by row.
  template <class F>
  void forEachTile(F&& f) const;
  void clear() { root_ = {}; }

  static constexpr int offset(int x, int y) {
    return ((y & (kTileCells - 1)) << kTileBits) | (x & (kTileCells - 1));
  }
  /// 512 x 512 blocks of 512 x 512 cells: 13 km by 13 km at 0.05 m. More is a runaway pose.
  static constexpr std::int64_t kMaxBlocks = 1 << 18;

 private:
  using Block = std::array<Cow<Tile>, kBlockTiles * kBlockTiles>;
  struct Root {
    CellBox box;  // in blocks
    std::vector<Cow<Block>> blocks;
    std::size_t index(int bx, int by) const {
      return static_cast<std::size_t>(by - box.y0) * (box.x1 - box.x0) + (bx - box.x0);
    }
    bool covers(int bx, int by) const {
      return bx >= box.x0 && bx < box.x1 && by >= box.y0 && by < box.y1;
    }
  };

  static constexpr int slot(int tx, int ty) {
    return ((ty & (kBlockTiles - 1)) << kBlockBits) | (tx & (kBlockTiles - 1));
  }
  const Block* block(int bx, int by) const {
    const Root* r = root_.get();
    return r && r->covers(bx, by) ? r->blocks[r->index(bx, by)].get() : nullptr;
  }
  static void grow(Root& root, int bx, int by);
  /// One tile a value, held for ever.
  static const std::array<Cow<Tile>, 256>& uniformTiles();
  Cow<Tile>& slotForWriting(int tx, int ty);

  Cow<Root> root_;
};

template <class T>
template <class F>
void TiledPlane<T>::forEachTile(F&& f) const {
  const CellBox box = tileBox();
  for (int ty = box.y0; ty < box.y1; ++ty)
    for (int tx = box.x0; tx < box.x1; ++tx)
      if (const Tile* t = tile(tx, ty)) f(tx, ty, *t);
}

extern template class TiledPlane<std::int8_t>;
extern template class TiledPlane<std::uint8_t>;

}  // namespace ariadne::grid
