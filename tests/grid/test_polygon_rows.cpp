#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "ariadne/core/random.h"
#include "polygon_rows.h"

using ariadne::grid::PolygonRows;
using mrpt::math::TPoint2D;

namespace {

/// Even-odd test of a point against every edge.
bool inside(const std::vector<TPoint2D>& polygon, double x, double y) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const TPoint2D& a = polygon[i];
    const TPoint2D& b = polygon[j];
    if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

std::set<std::pair<int, int>> filled(const PolygonRows& rows) {
  std::set<std::pair<int, int>> cells;
  for (int y = rows.firstRow(); y < rows.endRow(); ++y)
    rows.forEachSpan(y, [&](int x0, int x1) {
      for (int x = x0; x < x1; ++x) EXPECT_TRUE(cells.insert({x, y}).second) << "named twice";
    });
  return cells;
}

}  // namespace

TEST(PolygonRows, StarsAreFilledAsThePointTestSays) {
  ariadne::core::RandomStream rng(3, 0, 0, ariadne::core::Purpose::test);
  PolygonRows rows;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<TPoint2D> star;
    const TPoint2D centre(10 * rng.gaussian(), 10 * rng.gaussian());
    const int corners = 3 + static_cast<int>(rng.bits() % 200);
    for (int i = 0; i < corners; ++i) {
      const double r = 1 + 25 * rng.uniform();
      const double angle = 2 * M_PI * i / corners;
      star.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    rows.build(star);
    const auto cells = filled(rows);
    for (int y = -70; y < 70; ++y)
      for (int x = -70; x < 70; ++x)
        EXPECT_EQ(cells.count({x, y}) == 1, inside(star, x + 0.5, y + 0.5)) << x << ", " << y;
  }
}

TEST(PolygonRows, WholeCellsOfASquare) {
  PolygonRows rows;
  rows.build({{0, 0}, {3, 0}, {3, 2}, {0, 2}});
  EXPECT_EQ(filled(rows).size(), 6U);
}

TEST(PolygonRows, NothingFromNothing) {
  PolygonRows rows;
  for (const auto& polygon : {std::vector<TPoint2D>{}, {{1, 1}}, {{1, 1}, {5, 5}}}) {
    rows.build(polygon);
    EXPECT_TRUE(filled(rows).empty());
  }
  rows.build({{1, 1}, {1, 1}, {1, 1}});  // a laser that saw nothing
  EXPECT_TRUE(filled(rows).empty());
}
