// Where walls are, coarsely: one byte per cell, 1 where a beam ended. What a piece of the path is
// laid over when its place is searched for.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ariadne::loops {

class HitRaster {
 public:
  /// A square about `centre`, `half_m` to each side, of cells of `cell_m`.
  HitRaster(const mrpt::math::TPoint2D& centre, double half_m, double cell_m);

  double cell() const { return cell_m_; }
  /// Cells per side.
  int size() const { return size_; }
  int column(double x) const;
  int row(double y) const;
  /// Marks the cell of a point, m, map frame; points outside are left out.
  void mark(const mrpt::math::TPoint2D& p);
  /// 1 or 0; 0 outside.
  int at(int column, int row) const {
    return column < 0 || row < 0 || column >= size_ || row >= size_ ? 0 : line(row)[column];
  }
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
