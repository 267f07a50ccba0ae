#include "cells.h"

#include <algorithm>
#include <cstdint>

namespace ariadne::report {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

std::uint8_t shade(int log_odds) {
  if (log_odds == 0) return 205;
  return static_cast<std::uint8_t>(log_odds > 0 ? 225 + 30 * log_odds / 127
                                                : std::max(60 + 60 * log_odds / 127, 0));
}

/// The cell that stands for a block: its most occupied, else its most free, so that thin walls
/// stay.
int standsFor(const Grid& map, int x0, int y0, const Box& box, int cells) {
  int low = 0;
  int high = 0;
  for (int y = y0; y < std::min(y0 + cells, box.y1); ++y) {
    const auto* row = map.getRow(y);
    for (int x = x0; x < std::min(x0 + cells, box.x1); ++x) {
      low = std::min<int>(low, row[x]);
      high = std::max<int>(high, row[x]);
    }
  }
  return low < 0 ? low : high;
}

}  // namespace

Box knownCells(const Grid& map) {
  Box box{static_cast<int>(map.getSizeX()), static_cast<int>(map.getSizeY()), 0, 0};
  const auto known = [](auto cell) { return cell != 0; };
  for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y) {
    const auto* row = map.getRow(y);
    const auto* end = row + map.getSizeX();
    const auto* first = std::find_if(row, end, known);
    if (first == end) continue;
    const auto* last = end;
    while (!known(*--last)) continue;
    box = {std::min(box.x0, static_cast<int>(first - row)), std::min(box.y0, y),
           std::max(box.x1, static_cast<int>(last - row) + 1), y + 1};
  }
  return box.x0 < box.x1 ? box : Box{0, 0, 1, 1};
}

Scale Scale::fitting(int longest_cells, int side) {
  // A lone cell need not fill the picture.
  return {(longest_cells + side - 1) / side, std::clamp(side / longest_cells, 1, 40)};
}

void drawCells(cairo_surface_t* image, const Grid& map, const Box& box, const Scale& scale,
               int left, int bottom) {
  cairo_surface_flush(image);
  unsigned char* data = cairo_image_surface_get_data(image);
  const int stride = cairo_image_surface_get_stride(image);
  int pixel_y = bottom - scale.pixels;
  for (int y = box.y0; y < box.y1; y += scale.cells, pixel_y -= scale.pixels) {
    int pixel_x = left;
    for (int x = box.x0; x < box.x1; x += scale.cells, pixel_x += scale.pixels) {
      const std::uint32_t v = shade(standsFor(map, x, y, box, scale.cells));
      for (int j = 0; j < scale.pixels; ++j) {
        auto* row = reinterpret_cast<std::uint32_t*>(data + std::size_t(pixel_y + j) * stride);
        std::fill_n(row + pixel_x, scale.pixels, v << 16 | v << 8 | v);
      }
    }
  }
  cairo_surface_mark_dirty(image);
}

}  // namespace ariadne::report
