#include "thinning.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace ariadne::report {
namespace {

void dropEveryOther(std::vector<ReplayFrame>& frames) {
  bool drop = false;
  const std::size_t last = frames.back().step;
  const auto goes = [&](const ReplayFrame& f) {
    if (f.pinned || f.step == last) return false;
    drop = !drop;
    return !drop;
  };
  // stable_partition would move; remove_if calls in order
  frames.erase(std::remove_if(frames.begin(), frames.end(), goes), frames.end());
}

}  // namespace

bool thin(std::vector<ReplayFrame>& frames) {
  if (frames.size() < 3) return false;
  const std::size_t before = frames.size();
  dropEveryOther(frames);
  if (frames.size() < before) return true;
  for (ReplayFrame& f : frames) f.pinned = false;
  dropEveryOther(frames);
  return true;
}

std::vector<ReplayTile> usedTiles(std::vector<ReplayFrame>& frames,
                                  const std::vector<ReplayTile>& tiles) {
  // A tile's first place, the first keyframe there, and its old number.
  using Use = std::tuple<int, int, std::size_t, std::uint32_t>;
  std::vector<Use> uses;
  std::vector<bool> seen(tiles.size());
  for (const ReplayFrame& f : frames)
    for (const PlacedTile& t : f.map)
      if (t.tile != 0 && !seen[t.tile]) {
        seen[t.tile] = true;
        uses.emplace_back(t.y, t.x, f.step, t.tile);
      }
  std::sort(uses.begin(), uses.end());
  std::vector<std::uint32_t> number(tiles.size());
  std::vector<ReplayTile> used(1);
  for (const Use& use : uses) {
    number[std::get<3>(use)] = static_cast<std::uint32_t>(used.size());
    used.push_back(tiles[std::get<3>(use)]);
  }
  for (ReplayFrame& f : frames)
    for (PlacedTile& t : f.map) t.tile = number[t.tile];
  return used;
}

}  // namespace ariadne::report
