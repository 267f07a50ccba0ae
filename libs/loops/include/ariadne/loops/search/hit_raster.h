// Where walls are, coarsely: one byte per cell, 1 where a beam ended. What a piece of the path is
// laid over when its place is searched for.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ariadne::loops {

/// A square bitmap of where beams ended, for the correlation of scans: a byte per cell.
class HitRaster {
 public:
  /// A square about `centre`, `half_m` to each side, of cells of `cell_m`.
  HitRaster(const mrpt::math::TPoint2D& centre, double half_m, double cell_m);

  /// Side of a cell, m.
  double cell() const { return cell_m_; }
  /// Cells per side.
  int size() const { return size_; }
  /// Of a coordinate of the map frame, m; outside the raster below 0 or size() and more.
  int column(double x) const;
  /// As column(), from south to north.
  int row(double y) const;
  /// Marks the cell of a point, m, map frame; points outside are left out.
  void mark(const mrpt::math::TPoint2D& p);
  /// 1 or 0; 0 outside.
  int at(int column, int row) const {
    return column < 0 || row < 0 || column >= size_ || row >= size_ ? 0 : line(row)[column];
  }
  /// The cells of a row, from west to east: 1 where a beam ended.
  const std::uint8_t* line(int row) const {
    return hits_.data() + static_cast<std::ptrdiff_t>(row) * size_;
  }
  /// How many of the points lie on marked cells.
  std::size_t count(const std::vector<mrpt::math::TPoint2D>& points) const;

 private:
  double cell_m_;
  int size_;
  mrpt::math::TPoint2D low_;
  std::vector<std::uint8_t> hits_;
};

}  // namespace ariadne::loops
