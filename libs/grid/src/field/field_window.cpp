#include "field/field_window.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "tiles/bits.h"

namespace ariadne::grid {
namespace {

/// out = max(out, product(max(a, b), factor)). In 16 bits, so that the compiler can use lanes.
void raiseToProduct(std::uint8_t* __restrict out, const std::uint8_t* __restrict a,
                    const std::uint8_t* __restrict b, std::uint16_t factor) {
  for (int i = 0; i < kTileCells; ++i) {
    const std::uint8_t higher = a[i] > b[i] ? a[i] : b[i];
    const auto t = static_cast<std::uint16_t>(higher * factor + 128);
    const auto u = static_cast<std::uint16_t>(t + (t >> 8));
    const auto product = static_cast<std::uint8_t>(u >> 8);
    out[i] = out[i] > product ? out[i] : product;
  }
}

/// to = 255 where a bit is set.
void mark(std::uint8_t* to, std::uint32_t cells) {
  std::memset(to, 0, kTileCells);
  forEachBit(cells, [&](int x) { to[x] = 255; });
}

/// The cells of the tile `beside` columns of tiles away that are within `radius` columns of the
/// tile in work.
std::uint32_t withinReach(int beside, int radius) {
  const int columns = beside == 0 ? kTileCells : radius - (std::abs(beside) - 1) * kTileCells;
  if (columns >= kTileCells) return ~0U;
  return beside > 0 ? (1U << columns) - 1 : ~0U << (kTileCells - columns);
}

}  // namespace

void FieldWindow::build(const FieldKernel& kernel, const EvidencePlane& log_odds, int tx, int ty,
                        int y0, int y1) {
  const int r = kernel.radius();
  const int beside = (r + kTileCells - 1) >> kTileBits;  // tiles that reach in from each side
  const std::size_t tiles = 2 * static_cast<std::size_t>(beside) + 1;
  tiles_.assign(tiles, nullptr);
  rows_.resize(tiles);
  occupied_.resize(tiles_.size() * kTileCells);
  reach_.resize(tiles_.size());
  for (int i = -beside; i <= beside; ++i) reach_[i + beside] = withinReach(i, r);
  first_row_ = y0 - r;
  const int rows = y1 - y0 + 2 * r;
  spread_.resize(static_cast<std::size_t>(rows));
  any_.resize(static_cast<std::size_t>(rows));
  for (int y = y0 - r; y < y1 + r; ++y) {
    if (y == y0 - r || (y & (kTileCells - 1)) == 0)
      for (int i = -beside; i <= beside; ++i)
        tiles_[i + beside] = log_odds.tile(tx + i, y >> kTileBits);
    const auto at = static_cast<std::size_t>(y - first_row_);
    any_[at] = findOccupied(y);
    if (any_[at]) spread(kernel, spread_[at]);
  }
  for (int y = y0; y < y1; ++y) combine(kernel, y, field_[y - ty * kTileCells]);
}

/// Whether row y has occupied cells that reach into the window; marks them if so. Most rows have
/// none.
bool FieldWindow::findOccupied(int y) {
  std::uint32_t any = 0;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    rows_[i] = tiles_[i] ? tiles_[i]->occupiedRow(y & (kTileCells - 1)) & reach_[i] : 0;
    any |= rows_[i];
  }
  if (any == 0) return false;
  for (std::size_t i = 0; i < tiles_.size(); ++i) mark(&occupied_[i * kTileCells], rows_[i]);
  return true;
}

void FieldWindow::spread(const FieldKernel& kernel, Row& out) const {
  const std::uint8_t* middle = &occupied_[(tiles_.size() / 2) * kTileCells];
  Row sum;
  std::memcpy(sum.v, middle, kTileCells);
  for (int d = 1; d <= kernel.radius(); ++d) {
    const std::uint8_t value = kernel.along(d);
    const std::uint8_t* left = middle - d;
    const std::uint8_t* right = middle + d;
    for (int i = 0; i < kTileCells; ++i) {
      const auto v = static_cast<std::uint8_t>((left[i] | right[i]) & value);
      sum.v[i] = sum.v[i] > v ? sum.v[i] : v;
    }
  }
  out = sum;
}

void FieldWindow::combine(const FieldKernel& kernel, int y, Row& out) const {
  static const Row kNone{};
  const int at = y - first_row_;
  Row sum = any_[at] ? spread_[at] : kNone;
  for (int d = 1; d <= kernel.radius(); ++d) {
    if (!any_[at - d] && !any_[at + d]) continue;
    raiseToProduct(sum.v, any_[at - d] ? spread_[at - d].v : kNone.v,
                   any_[at + d] ? spread_[at + d].v : kNone.v, kernel.along(d));
  }
  out = sum;
}

}  // namespace ariadne::grid
