#include "ariadne/grid/field/likelihood_field.h"

#include <algorithm>
#include <cmath>

namespace ariadne::grid {
namespace {

/// True when `in` is somewhere over `out`, along one row of a tile.
bool raises(const std::uint8_t* in, const std::uint8_t* out) {
  std::uint8_t any = 0;
  for (int i = 0; i < kTileCells; ++i) any |= static_cast<std::uint8_t>(in[i] > out[i]);
  return any != 0;
}

void raise(std::uint8_t* __restrict out, const std::uint8_t* __restrict in) {
  for (int i = 0; i < kTileCells; ++i) out[i] = out[i] > in[i] ? out[i] : in[i];
}

}  // namespace

FieldKernel::FieldKernel(double sigma_cells)
    : radius_(std::max(1, static_cast<int>(std::ceil(3 * sigma_cells)))) {
  const auto value = [&](int d) {
    return static_cast<std::uint8_t>(
        std::lround(255 * std::exp(-d * d / (2 * sigma_cells * sigma_cells))));
  };
  while (radius_ > 1 && value(radius_) == 0) --radius_;
  stride_ = 2 * (radius_ + kTileCells) + 1;
  for (int d = -radius_; d <= radius_; ++d) line_.push_back(value(d));
  square_.assign(static_cast<std::size_t>(stride_) * (2 * radius_ + 1), 0);
  for (int dy = -radius_; dy <= radius_; ++dy)
    for (int dx = -radius_; dx <= radius_; ++dx)
      square_[(dy + radius_) * stride_ + radius_ + kTileCells + dx] =
          product(along(std::abs(dx)), along(std::abs(dy)));
}

LikelihoodField::LikelihoodField(double sigma_cells)
    : kernel_(std::make_shared<FieldKernel>(sigma_cells)) {}

void LikelihoodField::occupy(Cell cell) {
  // A very wide field is 255 beside an occupied cell too.
  if (at(cell.x, cell.y) == 255 && kernel_->along(1) < 255) return;
  const int r = kernel_->radius();
  for (int ty = (cell.y - r) >> Plane::kRowBits; ty <= (cell.y + r) >> Plane::kRowBits; ++ty)
    for (int tx = (cell.x - r) >> kTileBits; tx <= (cell.x + r) >> kTileBits; ++tx)
      stamp(cell, tx, ty);
}

/// The tile's share of the square about a cell, whole rows of the tile at a time: the square has
/// zeros on both sides. A shared tile is copied only for a change.
void LikelihoodField::stamp(Cell cell, int tx, int ty) {
  const int r = kernel_->radius();
  const int y0 = std::max(cell.y - r, ty * Plane::kRows);
  const int y1 = std::min(cell.y + r + 1, (ty + 1) * Plane::kRows);
  const auto in = [&](int y) { return kernel_->row(y - cell.y) + (tx * kTileCells - cell.x); };
  int y = y0;
  if (const Plane::Tile* now = plane_.tile(tx, ty))
    while (y < y1 && !raises(in(y), &(*now)[Plane::offset(0, y)])) ++y;
  if (y == y1) return;
  Plane::Tile& out = plane_.writeTile(tx, ty);
  for (; y < y1; ++y) raise(&out[Plane::offset(0, y)], in(y));
}

}  // namespace ariadne::grid
