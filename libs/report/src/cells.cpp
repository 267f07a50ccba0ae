#include "cells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace ariadne::report {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

std::uint8_t shade(int log_odds) {
  if (log_odds == 0) return 205;
  return static_cast<std::uint8_t>(log_odds > 0 ? 225 + 30 * log_odds / 127
                                                : std::max(60 + 60 * log_odds / 127, 0));
}

/// Grey pixels by log odds as an unsigned byte.
const std::array<std::uint32_t, 256>& greys() {
  static const auto table = [] {
    std::array<std::uint32_t, 256> t{};
    for (int l = -128; l < 128; ++l) t[static_cast<std::uint8_t>(l)] = 0x010101U * shade(l);
    return t;
  }();
  return table;
}

/// What stands for the blocks of some rows of cells, a byte a block: the most occupied cell, else
/// the most free, so that thin walls stay. Plain loops apart, so that the compiler uses lanes: with
/// a search in each block this took as long as making the file.
class BlockRow {
 public:
  BlockRow(const Grid& map, const Box& box, int cells)
      : map_(map),
        box_(box),
        cells_(cells),
        blocks_((box.width() + cells - 1) / cells),
        low_(blocks_ * cells),
        high_(low_.size()),
        value_(blocks_) {}

  /// The blocks whose first row is y, from the west.
  const std::vector<std::uint8_t>& read(int y) {
    std::fill(low_.begin(), low_.end(), 0);
    std::fill(high_.begin(), high_.end(), 0);
    std::int8_t* __restrict low = low_.data();
    std::int8_t* __restrict high = high_.data();
    for (int end = std::min(y + cells_, box_.y1); y < end; ++y) {
      const std::int8_t* __restrict row = map_.getRow(y) + box_.x0;
      for (int x = 0; x < box_.width(); ++x) {
        low[x] = low[x] < row[x] ? low[x] : row[x];
        high[x] = high[x] > row[x] ? high[x] : row[x];
      }
    }
    std::uint8_t* __restrict value = value_.data();
    for (std::size_t b = 0; b < blocks_; ++b, low += cells_, high += cells_) {
      int least = *low;
      int most = *high;
      for (int i = 1; i < cells_; ++i) {
        least = std::min<int>(least, low[i]);
        most = std::max<int>(most, high[i]);
      }
      value[b] = static_cast<std::uint8_t>(least < 0 ? least : most);
    }
    return value_;
  }

 private:
  const Grid& map_;
  const Box& box_;
  int cells_;
  std::size_t blocks_;
  std::vector<std::int8_t> low_;  // of each column; past the box they are 0
  std::vector<std::int8_t> high_;
  std::vector<std::uint8_t> value_;
};

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
  const auto& grey = greys();
  BlockRow blocks(map, box, scale.cells);
  int pixel_y = bottom - scale.pixels;
  for (int y = box.y0; y < box.y1; y += scale.cells, pixel_y -= scale.pixels) {
    auto* const row = reinterpret_cast<std::uint32_t*>(data + std::size_t(pixel_y) * stride) + left;
    auto* pixel = row;
    for (const std::uint8_t block : blocks.read(y))
      for (int i = 0; i < scale.pixels; ++i) *pixel++ = grey[block];
    for (int j = 1; j < scale.pixels; ++j)
      std::copy(row, pixel,
                reinterpret_cast<std::uint32_t*>(reinterpret_cast<char*>(row) +
                                                 std::ptrdiff_t{j} * stride));
  }
  cairo_surface_mark_dirty(image);
}

}  // namespace ariadne::report
