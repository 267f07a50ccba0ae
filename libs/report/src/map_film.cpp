#include "map_film.h"

#include <algorithm>

namespace ariadne::report {
namespace {

using grid::kTileCells;
static_assert(kTileCells == kReplayTile);

using Tile = grid::EvidenceTile;

/// Bit i * n becomes whether any of bits i * n to i * n + n - 1 is set; n is a power of 2.
std::uint32_t folded(std::uint32_t bits, int n) {
  for (int shift = 1; shift < n; shift *= 2) bits |= bits >> shift;
  return bits;
}

/// Tile (i, j) of the n x n that one is drawn of: its block of pixels, made anew.
void drawBlock(TilePixels& pixels, const Tile* tile, int i, int j, int n) {
  static_assert(static_cast<int>(MapPixel::free) == 1 && static_cast<int>(MapPixel::occupied) == 2);
  const int side = kReplayTile / n;
  std::uint8_t* block = &pixels[j * side * kReplayTile + i * side];
  for (int y = 0; y < side; ++y, block += kReplayTile) {
    std::uint32_t free = 0;
    std::uint32_t occupied = 0;
    for (int k = 0; tile && k < n; ++k) {
      free |= tile->freeRow(y * n + k);
      occupied |= tile->occupiedRow(y * n + k);
    }
    free = folded(free, n);
    occupied = folded(occupied, n);
    for (int x = 0; x < side; ++x)
      block[x] = (occupied >> x * n & 1U) != 0 ? 2 : static_cast<std::uint8_t>(free >> x * n & 1U);
  }
}

}  // namespace

std::uint32_t MapFilm::numberBefore(int x, int y) const {
  if (x < box_.x0 || x >= box_.x1 || y < box_.y0 || y >= box_.y1) return 0;
  return numbers_[static_cast<std::size_t>(y - box_.y0) * (box_.x1 - box_.x0) + (x - box_.x0)];
}

std::uint32_t MapFilm::draw(const grid::OccupancyGrid& map, int x, int y, TileStore& store) const {
  const int n = 1 << level_;
  const std::uint32_t number = numberBefore(x, y);
  TilePixels pixels{};
  bool changed = false;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Tile* tile = map.cells().tile(x * n + i, y * n + j);
      if (tile == before_.cells().tile(x * n + i, y * n + j)) continue;
      if (!changed && n > 1) pixels = unpack(store.tiles()[number]);
      changed = true;
      drawBlock(pixels, tile, i, j, n);
    }
  return changed ? store.add(pack(pixels)) : number;
}

std::vector<PlacedTile> MapFilm::take(const grid::OccupancyGrid& map, TileStore& store) {
  const grid::CellBox tiles = map.cells().tileBox();
  const int round_up = (1 << level_) - 1;
  const grid::CellBox box{tiles.x0 >> level_, tiles.y0 >> level_, (tiles.x1 + round_up) >> level_,
                          (tiles.y1 + round_up) >> level_};
  std::vector<PlacedTile> placed;
  std::vector<std::uint32_t> numbers;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) {
      numbers.push_back(draw(map, x, y, store));
      if (numbers.back() != 0) placed.push_back({x, y, numbers.back()});
    }
  before_ = map;
  box_ = box;
  numbers_ = std::move(numbers);
  return placed;
}

void MapFilm::restart(int level) {
  level_ = level;
  before_.clear();
  box_ = {};
}

}  // namespace ariadne::report
