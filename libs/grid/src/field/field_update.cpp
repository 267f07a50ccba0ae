// The field after many cells changed at once: each tile is made anew once, however many occupied
// cells are near it.
#include <algorithm>
#include <cstring>

#include "ariadne/grid/field/likelihood_field.h"
#include "field/field_window.h"

namespace ariadne::grid {
namespace {

/// Rows [y0, y1) of a tile of the field.
struct Part {
  int ty;
  int tx;
  int y0;
  int y1;
};

/// The parts of tiles that boxes reach when widened by `radius`; each tile once, in order.
std::vector<Part> partsNear(const std::vector<CellBox>& boxes, int radius) {
  std::vector<Part> parts;
  for (const CellBox& b : boxes) {
    const int y0 = b.y0 - radius;
    const int y1 = b.y1 + radius;
    for (int ty = y0 >> kTileBits; ty <= (y1 - 1) >> kTileBits; ++ty)
      for (int tx = (b.x0 - radius) >> kTileBits; tx <= (b.x1 - 1 + radius) >> kTileBits; ++tx)
        parts.push_back(
            {ty, tx, std::max(y0, ty * kTileCells), std::min(y1, (ty + 1) * kTileCells)});
  }
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.ty != b.ty ? a.ty < b.ty : a.tx < b.tx; });
  std::size_t kept = 0;
  for (const Part& p : parts) {
    if (kept > 0 && parts[kept - 1].ty == p.ty && parts[kept - 1].tx == p.tx) {
      parts[kept - 1].y0 = std::min(parts[kept - 1].y0, p.y0);
      parts[kept - 1].y1 = std::max(parts[kept - 1].y1, p.y1);
    } else {
      parts[kept++] = p;
    }
  }
  parts.resize(kept);
  return parts;
}

}  // namespace

void LikelihoodField::update(const std::vector<CellBox>& changed, const EvidencePlane& log_odds) {
  static thread_local FieldWindow window;
  for (const Part& part : partsNear(changed, kernel_->radius())) {
    window.build(*kernel_, log_odds, part.tx, part.ty, part.y0, part.y1);
    for (int y = part.y0; y < part.y1;) {
      const int ty = y >> Plane::kRowBits;
      const int end = std::min(part.y1, (ty + 1) * Plane::kRows);
      replaceRows(part.tx, y, end, window.row(y));
      y = end;
    }
  }
}

/// Rows [y0, y1) of one tile become these. A shared tile is copied only for a change.
void LikelihoodField::replaceRows(int tx, int y0, int y1, const std::uint8_t* rows) {
  static const Plane::Tile kNothing{};
  const int ty = y0 >> Plane::kRowBits;
  const Plane::Tile* now = plane_.tile(tx, ty);
  const auto size = static_cast<std::size_t>(y1 - y0) * kTileCells;
  const int begin = Plane::offset(0, y0);
  if (std::memcmp(&(now ? *now : kNothing)[begin], rows, size) == 0) return;
  std::memcpy(&plane_.writeTile(tx, ty)[begin], rows, size);
}

}  // namespace ariadne::grid
