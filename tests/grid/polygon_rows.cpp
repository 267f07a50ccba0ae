#include "polygon_rows.h"

#include <algorithm>

#include "ariadne/grid/tiles/rounding.h"

namespace ariadne::grid {
namespace {

using mrpt::math::TPoint2D;

/// First cell whose centre is at or past v.
int firstCentre(double v) { return ceilToInt(v - 0.5); }

/// Calls f(a, b, row0, row1) for each edge that crosses the centre of a row; a is the lower end.
template <class F>
void forEachEdge(const std::vector<TPoint2D>& vertices, F&& f) {
  const TPoint2D* from = &vertices.back();
  for (const TPoint2D& to : vertices) {
    const bool up = from->y < to.y;
    const TPoint2D& a = up ? *from : to;
    const TPoint2D& b = up ? to : *from;
    const int row0 = firstCentre(a.y);
    const int row1 = firstCentre(b.y);
    if (row0 < row1) f(a, b, row0, row1);
    from = &to;
  }
}

/// A row of a scan's outline meets the edges in the order of the beams: sorted already, one way or
/// the other.
void sortRow(int* begin, int* end) {
  if (end - begin > 1 && *begin > end[-1]) std::reverse(begin, end);
  if (end - begin > 24) {
    std::sort(begin, end);
    return;
  }
  for (int* i = begin + 1; i < end; ++i) {
    const int value = *i;
    int* j = i;
    for (; j > begin && value < j[-1]; --j) *j = j[-1];
    *j = value;
  }
}

}  // namespace

void PolygonRows::build(const std::vector<TPoint2D>& vertices) {
  row_ends_.clear();
  crossings_.clear();
  first_row_ = 0;
  if (vertices.size() < 3) return;
  const auto [low, high] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  first_row_ = firstCentre(low->y);
  const auto rows = static_cast<std::size_t>(std::max(0, firstCentre(high->y) - first_row_));
  begun_.assign(rows + 1, 0);
  forEachEdge(vertices, [&](const TPoint2D&, const TPoint2D&, int row0, int row1) {
    ++begun_[row0 - first_row_];
    --begun_[row1 - first_row_];
  });
  row_ends_.resize(rows);
  std::size_t total = 0;
  int count = 0;
  for (std::size_t r = 0; r < rows; ++r) {
    row_ends_[r] = total;  // where the row begins; moves on to its end below
    total += static_cast<std::size_t>(count += begun_[r]);
  }
  crossings_.resize(total);
  forEachEdge(vertices, [&](const TPoint2D& a, const TPoint2D& b, int row0, int row1) {
    const double slope = (b.x - a.x) / (b.y - a.y);
    double x = a.x + (row0 + 0.5 - a.y) * slope;
    std::size_t* end = &row_ends_[row0 - first_row_];
    for (int r = row0; r < row1; ++r, x += slope) crossings_[(*end++)++] = firstCentre(x);
  });
  std::size_t begin = 0;
  for (const std::size_t end : row_ends_) {
    sortRow(crossings_.data() + begin, crossings_.data() + end);
    begin = end;
  }
}

}  // namespace ariadne::grid
