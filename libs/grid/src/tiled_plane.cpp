#include "ariadne/grid/tiled_plane.h"

#include <algorithm>

#include "ariadne/core/error.h"

namespace ariadne::grid {

template <class T>
void TiledPlane<T>::grow(Root& root, int bx, int by) {
  Root wider;
  wider.box = root.blocks.empty()
                  ? CellBox{bx, by, bx + 1, by + 1}
                  : CellBox{std::min(root.box.x0, bx), std::min(root.box.y0, by),
                            std::max(root.box.x1, bx + 1), std::max(root.box.y1, by + 1)};
  const std::int64_t width = std::int64_t{wider.box.x1} - wider.box.x0;
  const std::int64_t height = std::int64_t{wider.box.y1} - wider.box.y0;
  if (width * height > kMaxBlocks)
    throw core::Error(
        "the map would span more than 68 billion cells: a pose ran away "
        "(check the odometry, or take a coarser resolution)");
  wider.blocks.resize(static_cast<std::size_t>(width * height));
  if (!root.blocks.empty())
    for (int y = root.box.y0; y < root.box.y1; ++y)
      for (int x = root.box.x0; x < root.box.x1; ++x)
        wider.blocks[wider.index(x, y)] = std::move(root.blocks[root.index(x, y)]);
  root = std::move(wider);
}

template <class T>
const std::array<Cow<typename TiledPlane<T>::Tile>, 256>& TiledPlane<T>::uniformTiles() {
  static const auto tiles = [] {
    std::array<Cow<Tile>, 256> all;
    for (int i = 0; i < 256; ++i) all[i].write().fill(static_cast<T>(i));
    return all;
  }();
  return tiles;
}

template <class T>
std::optional<T> TiledPlane<T>::uniformValue(const Tile* tile) {
  const T value = (*tile)[0];
  if (tile != uniformTiles()[static_cast<std::uint8_t>(value)].get()) return std::nullopt;
  return value;
}

template <class T>
void TiledPlane<T>::setUniform(int tx, int ty, T value) {
  slotForWriting(tx, ty) = uniformTiles()[static_cast<std::uint8_t>(value)];
}

template <class T>
typename TiledPlane<T>::Tile& TiledPlane<T>::writeTile(int tx, int ty) {
  return slotForWriting(tx, ty).write();
}

template <class T>
void TiledPlane<T>::setTile(int tx, int ty, const Tile& cells) {
  slotForWriting(tx, ty).assign(cells);
}

template <class T>
Cow<typename TiledPlane<T>::Tile>& TiledPlane<T>::slotForWriting(int tx, int ty) {
  const int bx = tx >> kBlockBits;
  const int by = ty >> kBlockBits;
  Root& root = root_.write();
  if (!root.covers(bx, by)) grow(root, bx, by);
  return root.blocks[root.index(bx, by)].write()[slot(tx, ty)];
}

template <class T>
CellBox TiledPlane<T>::tileBox() const {
  const Root* root = root_.get();
  if (!root || root->blocks.empty()) return {};
  return {root->box.x0 * kBlockTiles, root->box.y0 * kBlockTiles, root->box.x1 * kBlockTiles,
          root->box.y1 * kBlockTiles};
}

template class TiledPlane<std::int8_t>;
template class TiledPlane<std::uint8_t>;

}  // namespace ariadne::grid
