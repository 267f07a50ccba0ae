#include "tile_store.h"

#include <array>
#include <cstring>

namespace ariadne::report {
namespace {

/// FNV-1a, eight bytes at a time.
std::uint64_t hashOf(const ReplayTile& tile) {
  std::uint64_t hash = 14695981039346656037U;
  for (std::size_t i = 0; i < tile.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, tile.data() + i, sizeof word);
    hash = (hash ^ word) * 1099511628211U;
    hash ^= hash >> 32;  // a product carries nothing down
  }
  return hash;
}

}  // namespace

TileStore::TileStore() { add({}); }

std::uint32_t TileStore::add(const ReplayTile& tile) {
  const std::uint64_t hash = hashOf(tile);
  const auto [first, last] = numbers_.equal_range(hash);
  for (auto it = first; it != last; ++it)
    if (tiles_[it->second] == tile) return it->second;
  const auto number = static_cast<std::uint32_t>(tiles_.size());
  numbers_.emplace(hash, number);
  tiles_.push_back(tile);
  return number;
}

TilePixels unpack(const ReplayTile& tile) {
  // A byte's four pixels at once: it is done for most tiles of every keyframe.
  static const auto pixels_of = [] {
    std::array<std::array<std::uint8_t, 4>, 256> table{};
    for (std::size_t b = 0; b < table.size(); ++b)
      for (std::size_t i = 0; i < 4; ++i) table[b][i] = b >> (6 - 2 * i) & 3;
    return table;
  }();
  TilePixels pixels;
  for (std::size_t i = 0; i < tile.size(); ++i)
    std::memcpy(&pixels[4 * i], pixels_of[tile[i]].data(), 4);
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
