#include "map_film.h"

#include <algorithm>
#include <array>

namespace ariadne::report {
namespace {

using grid::kTileCells;
static_assert(kTileCells == kReplayTile);

using Tile = grid::EvidenceTile;

/// Bit i becomes whether bit 2 i or 2 i + 1 is set.
std::uint32_t halved(std::uint32_t bits) {
  bits = (bits | bits >> 1) & 0x55555555U;
  bits = (bits | bits >> 1) & 0x33333333U;
  bits = (bits | bits >> 2) & 0x0F0F0F0FU;
  bits = (bits | bits >> 4) & 0x00FF00FFU;
  return (bits | bits >> 8) & 0x0000FFFFU;
}

/// A drawn tile as bits: bit x of word y for pixel (x, y).
struct Bits {
  std::array<std::uint32_t, kReplayTile> free{};
  std::array<std::uint32_t, kReplayTile> occupied{};
};

/// Adds tile (i, j) of the 2^level x 2^level that one is drawn of.
void add(Bits& bits, const Tile& tile, int i, int j, int level) {
  const int halvings = std::min(level, grid::kTileBits);
  const int rows = 1 << halvings;  // of cells in one of pixels
  const int left = i * kTileCells >> level;
  for (int y = 0; y < kTileCells; y += rows) {
    std::uint32_t free = 0;
    std::uint32_t occupied = 0;
    for (int k = 0; k < rows; ++k) {
      free |= tile.freeRow(y + k);
      occupied |= tile.occupiedRow(y + k);
    }
    for (int k = 0; k < halvings; ++k) {
      free = halved(free);
      occupied = halved(occupied);
    }
    const int row = (j * kTileCells + y) >> level;
    bits.free[row] |= free << left;
    bits.occupied[row] |= occupied << left;
  }
}

/// A byte's four pixels by the bits of what is free (lower half) and occupied.
const std::array<std::uint8_t, 256>& fourPixels() {
  static const auto table = [] {
    std::array<std::uint8_t, 256> t{};
    for (int b = 0; b < 256; ++b)
      for (int i = 0; i < 4; ++i) {
        const MapPixel pixel = (b >> (4 + i) & 1) != 0 ? MapPixel::occupied
                               : (b >> i & 1) != 0     ? MapPixel::free
                                                       : MapPixel::unknown;
        t[b] |= static_cast<std::uint8_t>(static_cast<int>(pixel) << (6 - 2 * i));
      }
    return t;
  }();
  return table;
}

ReplayTile packed(const Bits& bits) {
  const auto& pixels = fourPixels();
  ReplayTile tile;
  std::uint8_t* byte = tile.data();
  for (int y = 0; y < kReplayTile; ++y)
    for (int x = 0; x < kReplayTile; x += 4)
      *byte++ = pixels[(bits.free[y] >> x & 15U) | (bits.occupied[y] >> x & 15U) << 4];
  return tile;
}

}  // namespace

std::uint32_t MapFilm::numberBefore(int x, int y) const {
  if (x < box_.x0 || x >= box_.x1 || y < box_.y0 || y >= box_.y1) return 0;
  return numbers_[static_cast<std::size_t>(y - box_.y0) * (box_.x1 - box_.x0) + (x - box_.x0)];
}

std::uint32_t MapFilm::draw(const grid::OccupancyGrid& map, int x, int y, TileStore& store) const {
  const int n = 1 << level_;
  const auto shown = [&](const grid::OccupancyGrid& of, int i, int j) {
    return of.cells().tile(x * n + i, y * n + j);
  };
  bool changed = false;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) changed |= shown(map, i, j) != shown(before_, i, j);
  if (!changed) return numberBefore(x, y);
  Bits bits;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      if (const Tile* tile = shown(map, i, j)) add(bits, *tile, i, j, level_);
  return store.add(packed(bits));
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
