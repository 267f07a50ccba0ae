#include "map_halving.h"

#include <algorithm>
#include <map>

namespace ariadne::report {
namespace {

/// A quarter of a tile, made of a whole one at twice the scale.
void shrinkInto(TilePixels& pixels, const ReplayTile& fine, int left, int bottom) {
  const TilePixels from = unpack(fine);
  for (int y = 0; y < kReplayTile; ++y)
    for (int x = 0; x < kReplayTile; ++x) {
      std::uint8_t& pixel = pixels[(bottom + y / 2) * kReplayTile + left + x / 2];
      pixel = std::max(pixel, from[y * kReplayTile + x]);
    }
}

}  // namespace

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
