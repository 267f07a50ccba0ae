#include "tile_store.h"

namespace ariadne::report {

TileStore::TileStore() { add({}); }

std::uint32_t TileStore::add(const ReplayTile& tile) {
  const auto [found, is_new] = numbers_.try_emplace(std::string(tile.begin(), tile.end()),
                                                    static_cast<std::uint32_t>(tiles_.size()));
  if (is_new) tiles_.push_back(tile);
  return found->second;
}

TilePixels unpack(const ReplayTile& tile) {
  TilePixels pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = tile[i / 4] >> (6 - 2 * (i % 4)) & 3;
  return pixels;
}

ReplayTile pack(const TilePixels& pixels) {
  ReplayTile tile{};
  for (std::size_t i = 0; i < tile.size(); ++i)
    tile[i] = static_cast<std::uint8_t>(pixels[4 * i] << 6 | pixels[4 * i + 1] << 4 |
                                        pixels[4 * i + 2] << 2 | pixels[4 * i + 3]);
  return tile;
}

}  // namespace ariadne::report
