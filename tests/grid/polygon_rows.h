// The tests' reference for what lies inside an outline; the grid itself converts to bits.
// Scanline conversion of a polygon: for each row of cells, the spans whose cell centres lie inside
// (even-odd rule). Each cell is named once, however many beams pass it.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace ariadne::grid {

class PolygonRows {
 public:
  /// @param vertices closed polygon in cells: cell (x, y) has its centre at (x + 0.5, y + 0.5).
  void build(const std::vector<mrpt::math::TPoint2D>& vertices);

  int firstRow() const { return first_row_; }
  int endRow() const { return first_row_ + static_cast<int>(row_ends_.size()); }
  /// Calls f(x0, x1) for each span [x0, x1) of cells of the row, from left to right.
  template <class F>
  void forEachSpan(int row, F&& f) const {
    const std::size_t r = static_cast<std::size_t>(row - first_row_);
    for (std::size_t i = r == 0 ? 0 : row_ends_[r - 1]; i + 1 < row_ends_[r]; i += 2)
      if (crossings_[i] < crossings_[i + 1]) f(crossings_[i], crossings_[i + 1]);
  }

 private:
  int first_row_ = 0;
  std::vector<std::size_t> row_ends_;  // end of each row's crossings
  std::vector<int> begun_;             // edges that begin less those that end, a row
  std::vector<int> crossings_;         // first cell with its centre right of the edge; sorted a row
};

}  // namespace ariadne::grid
