// Recorded maps at half the scale, when the map has outgrown its picture.
#pragma once
#include <vector>

#include "tile_store.h"

namespace ariadne::report {

/// Longer side of the box around the tiles, pixels.
int sideOf(const std::vector<PlacedTile>& map);

/// The same maps with 2 x 2 pixels made one; as if drawn at the next level.
void halve(std::vector<ReplayFrame>& frames, TileStore& store);

}  // namespace ariadne::report
