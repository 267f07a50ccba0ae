// Fewer keyframes, and no tile that nobody shows.
#pragma once
#include <vector>

#include "tile_store.h"

namespace ariadne::report {

/// Drops every other keyframe that is not pinned; where none is left to drop, all pins go first.
/// The first and the last stay. False when there are no more than these.
bool thin(std::vector<ReplayFrame>& frames);

/// Renumbers the tiles by place and, at one place, by the first keyframe that shows them, so that
/// neighbours are alike and compress well; drops the others.
std::vector<ReplayTile> usedTiles(std::vector<ReplayFrame>& frames,
                                  const std::vector<ReplayTile>& tiles);

}  // namespace ariadne::report
