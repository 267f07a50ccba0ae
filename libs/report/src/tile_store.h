// Tiles of the drawn map, each kept once: particles that descend from one have most in common.
#pragma once
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "ariadne/report/replay.h"

namespace ariadne::report {

class TileStore {
 public:
  TileStore();
  /// Number of this tile; a new one when there is none like it. 0 is the tile of unknown pixels.
  std::uint32_t add(const ReplayTile& tile);
  const std::vector<ReplayTile>& tiles() const { return tiles_; }

 private:
  std::vector<ReplayTile> tiles_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> numbers_;  // by a hash of the content
};

/// The pixels of a tile, one a byte, and back.
using TilePixels = std::array<std::uint8_t, kReplayTile * kReplayTile>;
TilePixels unpack(const ReplayTile& tile);
ReplayTile pack(const TilePixels& pixels);

}  // namespace ariadne::report
