// Reads the likelihood field between cells, bilinearly, with its gradient. Remembers the last tile:
// neighbouring beams end near each other.
#pragma once
#include <cmath>

#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/grid/tiles/rounding.h"

namespace ariadne::grid {

/// Field value in [0, 1] and its gradient, 1/m, map frame.
struct FieldSample {
  double value = 0;
  double dx = 0;
  double dy = 0;
};

/// Reads the likelihood field between cells' centres (bilinear), one point at a time.
class FieldSampler {
 public:
  /// The grid must outlive it and not change.
  explicit FieldSampler(const OccupancyGrid& grid)
      : plane_(grid.field()),
        cells_per_m_(1 / grid.resolution()),
        shift_x_(-grid.origin().x * cells_per_m_ - 0.5),
        shift_y_(-grid.origin().y * cells_per_m_ - 0.5) {}

  /// Value at (x, y), m, map frame, 0 to 255.
  double value(double x, double y) {
    const Corners c = corners(x, y);
    return (c.v00 * (1 - c.fx) + c.v10 * c.fx) * (1 - c.fy) +
           (c.v01 * (1 - c.fx) + c.v11 * c.fx) * c.fy;
  }

  /// Value and gradient at (x, y), m, map frame.
  FieldSample sample(double x, double y) {
    const Corners c = corners(x, y);
    const double low = c.v00 * (1 - c.fx) + c.v10 * c.fx;
    const double high = c.v01 * (1 - c.fx) + c.v11 * c.fx;
    const double scale = cells_per_m_ / 255;
    return {(low * (1 - c.fy) + high * c.fy) / 255,
            ((c.v10 - c.v00) * (1 - c.fy) + (c.v11 - c.v01) * c.fy) * scale, (high - low) * scale};
  }

 private:
  using Plane = LikelihoodField::Plane;
  struct Corners {
    double v00 = 0, v10 = 0, v01 = 0, v11 = 0;  // v(x)(y)
    double fx = 0, fy = 0;
  };

  const Plane::Tile* tile(int tx, int ty) {
    if (tx != tx_ || ty != ty_ || !looked_) {
      tile_ = plane_.tile(tx, ty);
      tx_ = tx;
      ty_ = ty;
      looked_ = true;
    }
    return tile_;
  }
  // Inlined by force: a fifth of the matcher's time was the call.
  __attribute__((always_inline)) Corners corners(double x, double y) {
    const double u = x * cells_per_m_ + shift_x_;
    const double v = y * cells_per_m_ + shift_y_;
    // Poses are bounded where scans are inserted; here a far one only has to read zeros.
    if (!(std::abs(u) < 1e9 && std::abs(v) < 1e9)) return {};
    const int ix = floorToInt(u);
    const int iy = floorToInt(v);
    Corners c;
    c.fx = u - ix;
    c.fy = v - iy;
    constexpr int kLastColumn = kTileCells - 1;
    constexpr int kLastRow = Plane::kRows - 1;
    if ((ix & kLastColumn) != kLastColumn && (iy & kLastRow) != kLastRow) {
      if (const Plane::Tile* t = tile(ix >> kTileBits, iy >> Plane::kRowBits)) {
        const std::uint8_t* p = &(*t)[Plane::offset(ix, iy)];
        c.v00 = p[0];
        c.v10 = p[1];
        c.v01 = p[kTileCells];
        c.v11 = p[kTileCells + 1];
      }
    } else {
      c.v00 = plane_.at(ix, iy);
      c.v10 = plane_.at(ix + 1, iy);
      c.v01 = plane_.at(ix, iy + 1);
      c.v11 = plane_.at(ix + 1, iy + 1);
    }
    return c;
  }

  const Plane& plane_;
  double cells_per_m_;
  double shift_x_;
  double shift_y_;
  const Plane::Tile* tile_ = nullptr;
  int tx_ = 0;
  int ty_ = 0;
  bool looked_ = false;
};

}  // namespace ariadne::grid
