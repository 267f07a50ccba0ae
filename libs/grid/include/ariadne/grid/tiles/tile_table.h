// Where the tiles of a plane lie: a table of two levels, a rectangle of blocks, each 8 x 8
// handles of tiles. Copying a table is one increment; the first write afterwards
// copies the rectangle, one block, and the handle decides about the tile.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ariadne/grid/tiles/cow.h"

namespace ariadne::grid {

constexpr int kTileBits = 5;
constexpr int kTileCells = 1 << kTileBits;  ///< side of a tile, cells
constexpr int kBlockBits = 3;
constexpr int kBlockTiles = 1 << kBlockBits;  ///< side of a block, tiles

/// 1024 x 1024 blocks of 256 x 256 cells: 13 km by 13 km at 0.05 m.
constexpr std::int64_t kMaxSquareBlocks = 1 << 20;

/// Half-open rectangle of cells (or tiles); empty when x0 >= x1.
struct CellBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  /// Without cells.
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

/// Handle shares a tile when copied, and is empty when made.
/// @tparam kMaxBlocks more is a runaway pose
template <class Handle, std::int64_t kMaxBlocks>
class TileTable {
 public:
  /// Handle of the tile with tile coordinates (cell >> kTileBits); null where no block is.
  const Handle* find(int tx, int ty) const {
    const Root* r = root_.get();
    const int bx = tx >> kBlockBits;
    const int by = ty >> kBlockBits;
    if (!r || !r->covers(bx, by)) return nullptr;
    const Block* b = r->blocks[r->index(bx, by)].get();
    return b ? &(*b)[slot(tx, ty)] : nullptr;
  }
  /// Handle for writing, valid until the next call. Throws core::Error when the table would span
  /// more than kMaxBlocks.
  Handle& at(int tx, int ty) {
    const int bx = tx >> kBlockBits;
    const int by = ty >> kBlockBits;
    Root& root = root_.write();
    if (!root.covers(bx, by)) grow(root, bx, by);
    return root.blocks[root.index(bx, by)].write()[slot(tx, ty)];
  }
  /// Box of the tiles that may hold something, in tile coordinates.
  CellBox tileBox() const {
    const Root* root = root_.get();
    if (!root || root->blocks.empty()) return {};
    return {root->box.x0 * kBlockTiles, root->box.y0 * kBlockTiles, root->box.x1 * kBlockTiles,
            root->box.y1 * kBlockTiles};
  }
  /// No tile is there.
  void clear() { root_ = {}; }

 private:
  using Block = std::array<Handle, kBlockTiles * kBlockTiles>;
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
  static void grow(Root& root, int bx, int by);

  Cow<Root> root_;
};

/// The box widened to hold block (bx, by). Throws core::Error when it would hold more than
/// `most` blocks.
CellBox widened(const CellBox& box, int bx, int by, std::int64_t most);

template <class Handle, std::int64_t kMaxBlocks>
void TileTable<Handle, kMaxBlocks>::grow(Root& root, int bx, int by) {
  Root wider;
  wider.box = widened(root.blocks.empty() ? CellBox{} : root.box, bx, by, kMaxBlocks);
  wider.blocks.resize(static_cast<std::size_t>(wider.box.x1 - wider.box.x0) *
                      static_cast<std::size_t>(wider.box.y1 - wider.box.y0));
  if (!root.blocks.empty())
    for (int y = root.box.y0; y < root.box.y1; ++y)
      for (int x = root.box.x0; x < root.box.x1; ++x)
        wider.blocks[wider.index(x, y)] = std::move(root.blocks[root.index(x, y)]);
  root = std::move(wider);
}

}  // namespace ariadne::grid
