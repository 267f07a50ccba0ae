#include "ariadne/grid/likelihood_field.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ariadne::grid {
namespace {

CellBox around(Cell c, int radius) {
  return {c.x - radius, c.y - radius, c.x + radius + 1, c.y + radius + 1};
}

CellBox intersection(const CellBox& a, const CellBox& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// Calls f(tx, ty, part) for each tile that the box touches; part is in cells of the plane.
template <class F>
void forEachTilePart(const CellBox& box, F&& f) {
  for (int ty = box.y0 >> kTileBits; ty <= (box.y1 - 1) >> kTileBits; ++ty)
    for (int tx = box.x0 >> kTileBits; tx <= (box.x1 - 1) >> kTileBits; ++tx)
      f(tx, ty,
        intersection(
            box, {tx * kTileCells, ty * kTileCells, (tx + 1) * kTileCells, (ty + 1) * kTileCells}));
}

}  // namespace

FieldKernel::FieldKernel(double sigma_cells)
    : radius_(static_cast<int>(std::ceil(3 * sigma_cells))) {
  for (int dy = -radius_; dy <= radius_; ++dy)
    for (int dx = -radius_; dx <= radius_; ++dx) {
      const double d2 = dx * dx + dy * dy;
      const bool inside = d2 <= 9 * sigma_cells * sigma_cells || d2 == 0;
      values_.push_back(inside ? static_cast<std::uint8_t>(std::lround(
                                     255 * std::exp(-d2 / (2 * sigma_cells * sigma_cells))))
                               : 0);
    }
}

LikelihoodField::LikelihoodField(double sigma_cells)
    : kernel_(std::make_shared<FieldKernel>(sigma_cells)) {}

void LikelihoodField::stamp(Cell centre, const CellBox& window) {
  forEachTilePart(intersection(window, around(centre, kernel_->radius())),
                  [&](int tx, int ty, const CellBox& part) {
                    auto& tile = plane_.writeTile(tx, ty);
                    for (int y = part.y0; y < part.y1; ++y) {
                      std::uint8_t* out = &tile[TiledPlane<std::uint8_t>::offset(part.x0, y)];
                      const std::uint8_t* in =
                          kernel_->row(y - centre.y) + (part.x0 - centre.x + kernel_->radius());
                      for (int i = 0; i < part.x1 - part.x0; ++i) out[i] = std::max(out[i], in[i]);
                    }
                  });
}

void LikelihoodField::occupy(Cell cell) {
  if (at(cell.x, cell.y) != 255) stamp(cell, around(cell, kernel_->radius()));
}

void LikelihoodField::release(Cell cell, const TiledPlane<std::int8_t>& log_odds) {
  const int radius = kernel_->radius();
  const CellBox window = around(cell, radius);
  forEachTilePart(window, [&](int tx, int ty, const CellBox& part) {
    auto& tile = plane_.writeTile(tx, ty);
    for (int y = part.y0; y < part.y1; ++y)
      std::memset(&tile[TiledPlane<std::uint8_t>::offset(part.x0, y)], 0, part.x1 - part.x0);
  });
  // Every occupied cell that reaches into the window is at most twice the radius away.
  forEachTilePart(around(cell, 2 * radius), [&](int tx, int ty, const CellBox& part) {
    const auto* tile = log_odds.tile(tx, ty);
    if (!tile) return;
    for (int y = part.y0; y < part.y1; ++y) {
      const std::int8_t* row = &(*tile)[TiledPlane<std::int8_t>::offset(part.x0, y)];
      for (int i = 0; i < part.x1 - part.x0; ++i)
        if (row[i] < 0) stamp({part.x0 + i, y}, window);
    }
  });
}

}  // namespace ariadne::grid
