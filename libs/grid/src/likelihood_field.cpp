#include "ariadne/grid/likelihood_field.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ariadne::grid {
namespace {

using Plane = TiledPlane<std::uint8_t>;

CellBox around(Cell c, int radius) {
  return {c.x - radius, c.y - radius, c.x + radius + 1, c.y + radius + 1};
}

/// Calls f(tx, ty, part) for each tile that the box touches; part is in cells of the plane.
template <class F>
void forEachTilePart(const CellBox& box, F&& f) {
  for (int ty = box.y0 >> kTileBits; ty <= (box.y1 - 1) >> kTileBits; ++ty)
    for (int tx = box.x0 >> kTileBits; tx <= (box.x1 - 1) >> kTileBits; ++tx)
      f(tx, ty,
        CellBox{std::max(box.x0, tx * kTileCells), std::max(box.y0, ty * kTileCells),
                std::min(box.x1, (tx + 1) * kTileCells), std::min(box.y1, (ty + 1) * kTileCells)});
}

/// out = max(out, in x factor), n a multiple of 16. In 16 bits, so that the compiler can use lanes.
void raiseToProduct(std::uint8_t* __restrict out, const std::uint8_t* __restrict in,
                    std::uint16_t factor, int n) {
  for (int block = 0; block < n; block += 16)
    for (int i = block; i < block + 16; ++i) {
      const auto t = static_cast<std::uint16_t>(in[i] * factor + 128);
      const auto u = static_cast<std::uint16_t>(t + (t >> 8));
      const auto product = static_cast<std::uint8_t>(u >> 8);
      out[i] = out[i] > product ? out[i] : product;
    }
}

/// True when no cell is occupied; eight at a time, by their signs.
bool noneNegative(const std::int8_t* cells, int n) {
  std::uint64_t signs = 0;
  int i = 0;
  for (; i + 8 <= n; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, cells + i, 8);
    signs |= word;
  }
  std::int8_t rest = 0;
  for (; i < n; ++i) rest = static_cast<std::int8_t>(rest | cells[i]);
  return (signs & 0x8080808080808080U) == 0 && rest >= 0;
}

/// A small dense window of the field, rebuilt from the occupied cells about it.
class Window {
 public:
  Window(const CellBox& box, const FieldKernel& kernel)
      : box_(box),
        kernel_(kernel),
        stride_((box.x1 - box.x0 + 15) & ~15),
        values_(static_cast<std::size_t>(stride_) * (box.y1 - box.y0), 0),
        row_(static_cast<std::size_t>(stride_), 0) {}

  void build(const TiledPlane<std::int8_t>& log_odds) {
    const int r = kernel_.radius();
    for (int y = box_.y0 - r; y < box_.y1 + r; ++y)
      if (spreadAlongX(log_odds, y)) spreadAlongY(y);
  }
  const std::uint8_t* row(int y) const { return &values_[(y - box_.y0) * stride_]; }

 private:
  /// row_ = field of the occupied cells of row y alone, at row y. False when there are none.
  bool spreadAlongX(const TiledPlane<std::int8_t>& log_odds, int y) {
    const int r = kernel_.radius();
    bool any = false;
    forEachTilePart({box_.x0 - r, y, box_.x1 + r, y + 1}, [&](int tx, int ty, const CellBox& part) {
      const auto* tile = log_odds.tile(tx, ty);
      if (!tile) return;
      const std::int8_t* cells = &(*tile)[TiledPlane<std::int8_t>::offset(part.x0, y)];
      if (noneNegative(cells, part.x1 - part.x0)) return;
      for (int i = 0; i < part.x1 - part.x0; ++i) {
        if (cells[i] >= 0) continue;
        if (!any) std::fill(row_.begin(), row_.end(), 0);
        any = true;
        raise(part.x0 + i);
      }
    });
    return any;
  }
  void raise(int x) {
    const int from = std::max(box_.x0, x - kernel_.radius());
    const int to = std::min(box_.x1, x + kernel_.radius() + 1);
    std::uint8_t* out = &row_[from - box_.x0];
    const std::uint8_t* in = kernel_.line() + (from - x);
    for (int i = 0; i < to - from; ++i) out[i] = std::max(out[i], in[i]);
  }
  void spreadAlongY(int y) {
    const int r = kernel_.radius();
    for (int to = std::max(box_.y0, y - r); to < std::min(box_.y1, y + r + 1); ++to) {
      raiseToProduct(&values_[(to - box_.y0) * stride_], row_.data(),
                     kernel_.along(std::abs(to - y)), stride_);
    }
  }

  CellBox box_;
  const FieldKernel& kernel_;
  int stride_;
  std::vector<std::uint8_t> values_;
  std::vector<std::uint8_t> row_;
};

/// True when `in` is somewhere over `out`.
bool raises(const std::uint8_t* in, const std::uint8_t* out, int n) {
  bool any = false;
  for (int i = 0; i < n; ++i) any |= in[i] > out[i];
  return any;
}

}  // namespace

FieldKernel::FieldKernel(double sigma_cells)
    : radius_(std::max(1, static_cast<int>(std::ceil(3 * sigma_cells)))) {
  for (int d = -radius_; d <= radius_; ++d)
    line_.push_back(static_cast<std::uint8_t>(
        std::lround(255 * std::exp(-d * d / (2 * sigma_cells * sigma_cells)))));
  for (int dy = -radius_; dy <= radius_; ++dy)
    for (int dx = -radius_; dx <= radius_; ++dx) square_.push_back(product(along(dx), along(dy)));
}

LikelihoodField::LikelihoodField(double sigma_cells)
    : kernel_(std::make_shared<FieldKernel>(sigma_cells)) {}

void LikelihoodField::occupy(Cell cell) {
  if (at(cell.x, cell.y) == 255) return;
  forEachTilePart(around(cell, kernel_->radius()), [&](int tx, int ty, const CellBox& part) {
    const int width = part.x1 - part.x0;
    Plane::Tile* out = nullptr;
    const Plane::Tile* now = plane_.tile(tx, ty);
    for (int y = part.y0; y < part.y1; ++y) {
      const std::uint8_t* in = kernel_->row(y - cell.y) + (part.x0 - cell.x);
      const int offset = Plane::offset(part.x0, y);
      if (!out && now && !raises(in, &(*now)[offset], width)) continue;
      if (!out) out = &plane_.writeTile(tx, ty);  // a shared tile is copied only for a change
      for (int i = 0; i < width; ++i) (*out)[offset + i] = std::max((*out)[offset + i], in[i]);
    }
  });
}

void LikelihoodField::release(Cell cell, const TiledPlane<std::int8_t>& log_odds) {
  const CellBox box = around(cell, kernel_->radius());
  Window window(box, *kernel_);
  window.build(log_odds);
  forEachTilePart(box, [&](int tx, int ty, const CellBox& part) {
    const Plane::Tile* now = plane_.tile(tx, ty);
    if (!now) return;  // nothing was occupied near here
    Plane::Tile* out = nullptr;
    for (int y = part.y0; y < part.y1; ++y) {
      const std::uint8_t* in = window.row(y) + (part.x0 - box.x0);
      const auto width = static_cast<std::size_t>(part.x1 - part.x0);
      const int offset = Plane::offset(part.x0, y);
      if (!out && std::memcmp(&(*now)[offset], in, width) == 0) continue;
      if (!out) out = &plane_.writeTile(tx, ty);
      std::memcpy(&(*out)[offset], in, width);
    }
  });
}

}  // namespace ariadne::grid
