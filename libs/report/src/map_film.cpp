#include "map_film.h"

#include <algorithm>

namespace ariadne::report {
namespace {

using grid::kTileCells;
static_assert(kTileCells == kReplayTile);

using Tile = grid::EvidenceTile;

/// Eight bits as eight bytes of 0 or 1, the lowest bit first in memory.
std::array<std::uint8_t, 8> bytesOf(std::uint8_t bits) {
  static const auto table = [] {
    std::array<std::array<std::uint8_t, 8>, 256> t{};
    for (std::size_t b = 0; b < t.size(); ++b)
      for (std::size_t i = 0; i < 8; ++i) t[b][i] = b >> i & 1;
    return t;
  }();
  return table[bits];
}

/// Each pixel becomes what the cell of its column is where that is more; eight at a time.
void raise(std::array<std::uint8_t, kTileCells>& pixels, const Tile& tile, int y) {
  static_assert(static_cast<int>(MapPixel::free) == 1 && static_cast<int>(MapPixel::occupied) == 2);
  const std::uint32_t free = tile.freeRow(y);
  const std::uint32_t occupied = tile.occupiedRow(y);
  for (int x = 0; x < kTileCells; x += 8) {
    const auto frees = bytesOf(static_cast<std::uint8_t>(free >> x));
    const auto walls = bytesOf(static_cast<std::uint8_t>(occupied >> x));
    for (int i = 0; i < 8; ++i)
      pixels[x + i] = std::max<std::uint8_t>(pixels[x + i], frees[i] | walls[i] << 1);
  }
}

/// Tile (i, j) of the n x n that one is drawn of: its block of pixels, made anew. Rows are put
/// together first, many cells at a time.
void drawBlock(TilePixels& pixels, const Tile* tile, int i, int j, int n) {
  const int side = kReplayTile / n;
  std::uint8_t* block = &pixels[j * side * kReplayTile + i * side];
  for (int y = 0; y < side; ++y, block += kReplayTile) {
    std::array<std::uint8_t, kTileCells> row{};
    for (int k = 0; tile && k < n; ++k) raise(row, *tile, y * n + k);
    for (int x = 0; x < side; ++x)
      block[x] = *std::max_element(row.begin() + x * n, row.begin() + (x + 1) * n);
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
