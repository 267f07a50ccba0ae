#include "map_film.h"

#include <algorithm>
#include <map>

namespace ariadne::report {
namespace {

using grid::kTileCells;
static_assert(kTileCells == kReplayTile);

std::int64_t placeKey(int x, int y) { return (std::int64_t{y} << 32) + x; }

std::uint8_t pixelOf(std::int8_t log_odds) {
  if (log_odds == 0) return static_cast<std::uint8_t>(MapPixel::unknown);
  return static_cast<std::uint8_t>(log_odds > 0 ? MapPixel::free : MapPixel::occupied);
}

void raise(std::uint8_t& pixel, std::uint8_t to) { pixel = std::max(pixel, to); }

/// A quarter of a tile, made of a whole one at twice the scale.
void shrinkInto(TilePixels& pixels, const ReplayTile& fine, int left, int bottom) {
  const TilePixels from = unpack(fine);
  for (int y = 0; y < kReplayTile; ++y)
    for (int x = 0; x < kReplayTile; ++x)
      raise(pixels[(bottom + y / 2) * kReplayTile + left + x / 2], from[y * kReplayTile + x]);
}

}  // namespace

bool MapFilm::unchanged(const grid::OccupancyGrid& map, int x, int y) const {
  for (int ty = y << level_; ty < (y + 1) << level_; ++ty)
    for (int tx = x << level_; tx < (x + 1) << level_; ++tx)
      if (map.cells().tile(tx, ty) != before_.cells().tile(tx, ty)) return false;
  return true;
}

ReplayTile MapFilm::draw(const grid::OccupancyGrid& map, int x, int y) const {
  TilePixels pixels{};
  const int n = 1 << level_;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto* tile = map.cells().tile((x << level_) + i, (y << level_) + j);
      if (!tile) continue;
      for (int cy = 0; cy < kTileCells; ++cy)
        for (int cx = 0; cx < kTileCells; ++cx) {
          const int px = (i * kTileCells + cx) >> level_;
          const int py = (j * kTileCells + cy) >> level_;
          raise(pixels[py * kReplayTile + px], pixelOf((*tile)[cy * kTileCells + cx]));
        }
    }
  return pack(pixels);
}

std::vector<PlacedTile> MapFilm::take(const grid::OccupancyGrid& map, TileStore& store) {
  std::vector<PlacedTile> table;
  std::unordered_map<std::int64_t, std::uint32_t> drawn;
  const grid::CellBox box = map.cells().tileBox();
  const int round_up = (1 << level_) - 1;
  for (int y = box.y0 >> level_; y < (box.y1 + round_up) >> level_; ++y)
    for (int x = box.x0 >> level_; x < (box.x1 + round_up) >> level_; ++x) {
      const auto known = drawn_.find(placeKey(x, y));
      const std::uint32_t number = known != drawn_.end() && unchanged(map, x, y)
                                       ? known->second
                                       : store.add(draw(map, x, y));
      drawn.emplace(placeKey(x, y), number);
      if (number != 0) table.push_back({x, y, number});
    }
  before_ = map;
  drawn_ = std::move(drawn);
  return table;
}

void MapFilm::restart(int level) {
  level_ = level;
  drawn_.clear();
}

int sideOf(const std::vector<PlacedTile>& map) {
  if (map.empty()) return 0;
  const auto by_x = [](const PlacedTile& a, const PlacedTile& b) { return a.x < b.x; };
  const auto [left, right] = std::minmax_element(map.begin(), map.end(), by_x);
  return kReplayTile * (std::max(right->x - left->x, map.back().y - map.front().y) + 1);
}

void halve(std::vector<ReplayFrame>& frames, TileStore& store) {
  TileStore coarse;
  std::map<std::array<std::uint32_t, 4>, std::uint32_t> made;  // by the four tiles it is made of
  for (ReplayFrame& frame : frames) {
    std::map<std::pair<int, int>, std::array<std::uint32_t, 4>> quarters;  // by (y, x)
    for (const PlacedTile& t : frame.map)
      quarters[{t.y >> 1, t.x >> 1}][2 * (t.y & 1) + (t.x & 1)] = t.tile;
    frame.map.clear();
    for (const auto& [place, four] : quarters) {
      const auto [found, is_new] = made.try_emplace(four, 0);
      if (is_new) {
        TilePixels pixels{};
        for (int q = 0; q < 4; ++q)
          shrinkInto(pixels, store.tiles()[four[q]], q % 2 * kReplayTile / 2,
                     q / 2 * kReplayTile / 2);
        found->second = coarse.add(pack(pixels));
      }
      frame.map.push_back({place.second, place.first, found->second});
    }
  }
  store = std::move(coarse);
}

}  // namespace ariadne::report
