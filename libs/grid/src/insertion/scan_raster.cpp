#include "insertion/scan_raster.h"

#include <algorithm>
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/grid/tiles/rounding.h"
#include "field/two_doubles.h"

namespace ariadne::grid {
namespace {

/// Past this a cell's number would not fit; nothing real is so far away.
constexpr double kFarthestCell = 1e8;
/// 13 km by 13 km at 0.05 m, as far as a map may grow.
constexpr double kMostTiles = 1 << 26;

/// First cell whose centre is at or past v.
int firstCentre(double v) { return ceilToInt(v - 0.5); }

/// The same of two, |v| under 2^31, in the low halves.
inline TwoInts firstCentres(TwoDoubles v) {
  const TwoDoubles w = v - 0.5;
  TwoInts nearest_int;
  const TwoDoubles nearest = rounded(w, nearest_int);
  const TwoInts under = nearest < w;  // -1 where it is
  return nearest_int - under;
}

}  // namespace

CellsFromRobot::CellsFromRobot(const mrpt::math::TPose2D& map_from_robot,
                               const mrpt::math::TPoint2D& origin, double resolution_m)
    : x0((map_from_robot.x - origin.x) / resolution_m),
      y0((map_from_robot.y - origin.y) / resolution_m),
      c(std::cos(map_from_robot.phi) / resolution_m),
      s(std::sin(map_from_robot.phi) / resolution_m) {
  if (!(std::abs(x0) < kFarthestCell && std::abs(y0) < kFarthestCell && std::isfinite(c)))
    throw core::Error("a scan cannot be inserted: its pose is not a finite place near the map");
}

void ScanRaster::build(const ScanShape& shape, const CellsFromRobot& cells_from_robot) {
  placed_.resize(shape.outline.size() + shape.hits.size());
  place(shape.outline, cells_from_robot, placed_.data());
  place(shape.hits, cells_from_robot, placed_.data() + shape.outline.size());
  cover();
  if (shape.outline.size() > 2) crossEdges(shape.outline.size());
  markHits(shape.outline.size());
}

void ScanRaster::place(const std::vector<Point>& points, const CellsFromRobot& t, Point* to) {
  for (const Point& p : points) {
    to->x = t.x0 + t.c * p.x - t.s * p.y;
    to->y = t.y0 + t.s * p.x + t.c * p.y;
    ++to;
  }
}

/// Lays the index over all points, with a cell to spare for what rounding adds to a crossing.
void ScanRaster::cover() {
  box_ = {};
  width_ = 0;
  index_.clear();
  used_ = 1;
  if (placed_.empty()) return;
  TwoDoubles least = twoAt(&placed_.front().x);  // x and y
  TwoDoubles most = least;
  TwoDoubles none = {0, 0};  // NaN when a point is not finite
  for (const Point& p : placed_) {
    const TwoDoubles v = twoAt(&p.x);
    least = v < least ? v : least;
    most = v > most ? v : most;
    none += v - v;
  }
  const Point low{least[0], least[1]};
  const Point high{most[0], most[1]};
  constexpr double kTile = kTileCells;
  const double tiles = ((high.x - low.x) / kTile + 2) * ((high.y - low.y) / kTile + 2);
  if (none[0] != 0 || none[1] != 0 || !(std::max(-low.x, high.x) < 2 * kFarthestCell) ||
      !(std::max(-low.y, high.y) < 2 * kFarthestCell) || tiles > kMostTiles)
    throw core::Error("a scan cannot be inserted: it reaches past all bounds");
  box_ = {(floorToInt(low.x) - 1) >> kTileBits, (floorToInt(low.y) - 1) >> kTileBits,
          ((floorToInt(high.x) + 2) >> kTileBits) + 1, ((floorToInt(high.y) + 2) >> kTileBits) + 1};
  width_ = static_cast<std::size_t>(box_.x1 - box_.x0);
  index_.assign(width_ * static_cast<std::size_t>(box_.y1 - box_.y0), 0);
}

void ScanRaster::crossEdges(std::size_t outline) {
  row_.resize(outline);
  for (std::size_t i = 0; i < outline; ++i) row_[i] = firstCentre(placed_[i].y);
  Cursor cursor{box_.x1, box_.y1, nullptr};  // outside the box
  std::size_t from = outline - 1;
  for (std::size_t to = 0; to < outline; from = to++) {
    if (row_[from] < row_[to]) crossEdge(placed_[from], placed_[to], row_[from], row_[to], cursor);
    if (row_[from] > row_[to]) crossEdge(placed_[to], placed_[from], row_[to], row_[from], cursor);
  }
}

/// Flips a bit where the edge from a up to b crosses the centre line of a row: at the first cell
/// whose centre is right of it.
inline void ScanRaster::crossEdge(const Point& a, const Point& b, int y, int end, Cursor& cursor) {
  const double slope = (b.x - a.x) / (b.y - a.y);
  double x = a.x + (y + 0.5 - a.y) * slope;
  while (y < end) {
    const int ty = y >> kTileBits;
    const int next = std::min(end, (ty + 1) * kTileCells);
    if (ty != cursor.ty) cursor = {box_.x1, ty, nullptr};  // outside the box
    for (; y + 1 < next; y += 2) {
      const double x1 = x + slope;
      const TwoInts columns = firstCentres(TwoDoubles{x, x1});
      x = x1 + slope;
      flip(static_cast<int>(columns[0]), y, cursor);
      flip(static_cast<int>(columns[1]), y + 1, cursor);
    }
    if (y < next) {
      flip(firstCentre(x), y, cursor);
      ++y;
      x += slope;
    }
  }
}

inline void ScanRaster::flip(int column, int y, Cursor& cursor) {
  if (const int tx = column >> kTileBits; tx != cursor.tx) {
    cursor.tx = tx;
    cursor.rows = slot(tx, cursor.ty).crossed.rows.data();
  }
  cursor.rows[y & (kTileCells - 1)] ^= 1U << (column & (kTileCells - 1));
}

void ScanRaster::markHits(std::size_t first) {
  hits_.resize(placed_.size() - first);
  std::size_t count = 0;
  for (std::size_t i = first; i < placed_.size(); ++i) {
    const Cell cell{floorToInt(placed_[i].x), floorToInt(placed_[i].y)};
    const int x = cell.x & (kTileCells - 1);
    std::uint32_t& row =
        slot(cell.x >> kTileBits, cell.y >> kTileBits).hit.rows[cell.y & (kTileCells - 1)];
    hits_[count] = cell;
    count += (row >> x & 1U) ^ 1U;  // the next one takes its place when it was hit already
    row |= 1U << x;
  }
  hits_.resize(count);
}

std::uint32_t ScanRaster::newSlot() {
  if (used_ >= slots_.size()) slots_.resize(std::max<std::size_t>(64, 2 * slots_.size()));
  slots_[used_] = {};
  return used_++;
}

}  // namespace ariadne::grid
