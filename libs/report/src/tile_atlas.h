// Tiles as pictures that a browser can read without help: PNGs of two bits a pixel in data URIs. A
// row of pixels is a whole tile, row by row: libpng and zlib are called for each row, and with rows
// of a tile that took a third of the steps of writing the report.
#pragma once
#include <string>
#include <vector>

#include "ariadne/report/replay.h"

namespace ariadne::report {

/// 1024 x 4000 pixels, under what any browser takes.
constexpr std::size_t kTilesPerPicture = 4000;

/// Tile i is in picture i / kTilesPerPicture, from the top; its southern row comes first.
std::vector<std::string> tilePictures(const std::vector<ReplayTile>& tiles);

/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace ariadne::report
