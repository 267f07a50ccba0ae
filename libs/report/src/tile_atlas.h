// Tiles as pictures that a browser can read without help: columns of tiles, each a PNG of two bits
// a pixel in a data URI.
#pragma once
#include <string>
#include <vector>

#include "ariadne/report/replay.h"

namespace ariadne::report {

/// Tiles of one column: 16000 pixels, under what any browser takes.
constexpr std::size_t kTilesPerColumn = 500;

/// Tile i is in column i / kTilesPerColumn, from the top; its southern row is the upper one.
std::vector<std::string> tileColumns(const std::vector<ReplayTile>& tiles);

/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace ariadne::report
