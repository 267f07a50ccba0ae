// How a scan enters the grid. Three quarters of a filter's time would go here with a fill ray by
// ray, since beams overlap near the robot; the outline's rows name each cell once.
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/grid/occupancy_grid.h"
#include "ariadne/grid/polygon_rows.h"
#include "ariadne/grid/rounding.h"
#include "row_fill.h"

namespace ariadne::grid {
namespace {

using mrpt::math::TPoint2D;
using Plane = TiledPlane<std::int8_t>;

struct Hit {
  Cell cell;
  std::int8_t before;
};

/// Fills spans of one tile row after the other, with the tiles of a row looked up once. A tile is
/// asked for writing (and perhaps copied) only when a cell of it really changes.
class SpanFiller {
 public:
  SpanFiller(Plane& cells, std::int8_t amount, std::vector<Cell>& freed)
      : cells_(cells), amount_(amount), freed_(freed) {}

  void startTileRow(int ty, int tx_begin, int tx_end) {
    ty_ = ty;
    tx_begin_ = tx_begin;
    tiles_.assign(static_cast<std::size_t>(tx_end - tx_begin), {});
  }

  void fill(int y, int x0, int x1) {
    for (int tx = x0 >> kTileBits; tx <= (x1 - 1) >> kTileBits; ++tx) {
      const int base = tx * kTileCells;
      const int begin = std::max(x0 - base, 0);
      const int end = std::min(x1 - base, kTileCells);
      for (int half = begin & ~(kLanes - 1); half < end; half += kLanes)
        fillLanes(tx, base + half, y, std::max(begin - half, 0), std::min(end - half, kLanes));
    }
  }

 private:
  struct OpenTile {
    const std::int8_t* read = nullptr;
    std::int8_t* write = nullptr;
  };

  OpenTile& open(int tx) {
    OpenTile& tile = tiles_[static_cast<std::size_t>(tx - tx_begin_)];
    if (!tile.read) {
      const auto* t = cells_.tile(tx, ty_);
      tile.read = t ? t->data() : makeWritable(tx, tile);
    }
    return tile;
  }
  const std::int8_t* makeWritable(int tx, OpenTile& tile) {
    tile.write = cells_.writeTile(tx, ty_).data();
    tile.read = tile.write;
    return tile.read;
  }
  void fillLanes(int tx, int x, int y, int begin, int end) {
    OpenTile& tile = open(tx);
    const int offset = Plane::offset(x, y);
    const FillLanes lanes(begin, end, amount_);
    const FillChange change = lanes.change(tile.read + offset);
    if (!change.any) return;
    if (!tile.write) makeWritable(tx, tile);
    lanes.apply(tile.write + offset);
    for (unsigned bits = change.freed; bits != 0; bits &= bits - 1)
      freed_.push_back({x + __builtin_ctz(bits), y});
  }

  Plane& cells_;
  std::int8_t amount_;
  std::vector<Cell>& freed_;
  std::vector<OpenTile> tiles_;
  int ty_ = 0;
  int tx_begin_ = 0;
};

/// Buffers that a thread keeps from scan to scan.
struct Scratch {
  std::vector<TPoint2D> outline;
  std::vector<Hit> hits;
  std::vector<Cell> freed;
  PolygonRows rows;
};

void fillOutline(Plane& cells, std::int8_t amount, Scratch& scratch) {
  scratch.rows.build(scratch.outline);
  if (scratch.outline.empty()) return;
  const auto [left, right] =
      std::minmax_element(scratch.outline.begin(), scratch.outline.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  const int tx_begin = floorToInt(left->x) >> kTileBits;
  const int tx_end = (ceilToInt(right->x) >> kTileBits) + 1;
  SpanFiller filler(cells, amount, scratch.freed);
  int open_row = 0;
  for (int y = scratch.rows.firstRow(); y < scratch.rows.endRow(); ++y) {
    if (y == scratch.rows.firstRow() || y >> kTileBits != open_row) {
      open_row = y >> kTileBits;
      filler.startTileRow(open_row, tx_begin, tx_end);
    }
    scratch.rows.forEachSpan(y, [&](int x0, int x1) { filler.fill(y, x0, x1); });
  }
}

/// Past this a cell's number would not fit; nothing real is so far away.
constexpr double kFarthestCell = 1e8;

}  // namespace

void OccupancyGrid::insert(const ScanShape& shape, const mrpt::math::TPose2D& map_from_robot) {
  static thread_local Scratch scratch;
  const double c = std::cos(map_from_robot.phi) / resolution_;
  const double s = std::sin(map_from_robot.phi) / resolution_;
  const double x0 = (map_from_robot.x - origin_.x) / resolution_;
  const double y0 = (map_from_robot.y - origin_.y) / resolution_;
  if (!(std::abs(x0) < kFarthestCell && std::abs(y0) < kFarthestCell && std::isfinite(c)))
    throw core::Error("a scan cannot be inserted: its pose is not a finite place near the map");
  const auto toCells = [&](const TPoint2D& p) {
    return TPoint2D(x0 + c * p.x - s * p.y, y0 + s * p.x + c * p.y);
  };

  scratch.outline.clear();
  for (const TPoint2D& p : shape.outline) scratch.outline.push_back(toCells(p));
  // What the hit cells held before any change: a cell hit twice, or passed and hit, is hit once.
  scratch.hits.clear();
  for (const TPoint2D& p : shape.hits) {
    const TPoint2D v = toCells(p);
    const Cell cell{floorToInt(v.x), floorToInt(v.y)};
    scratch.hits.push_back({cell, at(cell)});
  }
  scratch.freed.clear();
  fillOutline(cells_, evidence_.free, scratch);

  for (const Hit& hit : scratch.hits) {
    const int after = std::max(hit.before - evidence_.occupied, int{kMostOccupied});
    if (at(hit.cell) != after) cells_.set(hit.cell.x, hit.cell.y, static_cast<std::int8_t>(after));
    if (hit.before >= 0 && after < 0) field_.occupy(hit.cell);
  }
  for (const Cell cell : scratch.freed)
    if (at(cell) >= 0) field_.release(cell, cells_);
}

}  // namespace ariadne::grid
