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

/// Reads cells near each other: the last tile is remembered. Valid until the plane is written to.
class CellReader {
 public:
  explicit CellReader(const Plane& plane) : plane_(plane) {}
  std::int8_t at(Cell c) {
    const int tx = c.x >> kTileBits;
    const int ty = c.y >> kTileBits;
    if (!looked_ || tx != tx_ || ty != ty_) {
      tile_ = plane_.tile(tx, ty);
      tx_ = tx;
      ty_ = ty;
      looked_ = true;
    }
    return tile_ ? (*tile_)[Plane::offset(c.x, c.y)] : std::int8_t{0};
  }

 private:
  const Plane& plane_;
  const Plane::Tile* tile_ = nullptr;
  int tx_ = 0;
  int ty_ = 0;
  bool looked_ = false;
};

/// A tile of the row in work.
struct OpenTile {
  const std::int8_t* read = nullptr;
  std::int8_t* write = nullptr;
  int covered_rows = 0;  // rows of it that lie inside the outline
};

/// Buffers that a thread keeps from scan to scan.
struct Scratch {
  std::vector<TPoint2D> outline;
  std::vector<Hit> hits;
  std::vector<Cell> freed;
  std::vector<OpenTile> tiles;
  PolygonRows rows;
};

/// Adds evidence for free to one tile row after the other. A tile is asked for writing (and perhaps
/// copied) only when a cell of it really changes.
class TileRowFiller {
 public:
  TileRowFiller(Plane& cells, std::int8_t amount, Scratch& scratch)
      : cells_(cells),
        lanes_(amount),
        rows_(scratch.rows),
        freed_(scratch.freed),
        tiles_(scratch.tiles) {}

  /// The rows [y0, y1) of tile row ty, whose tiles are [tx_begin, tx_end).
  void fill(int ty, int y0, int y1, int tx_begin, int tx_end) {
    ty_ = ty;
    tx_begin_ = tx_begin;
    tiles_.assign(static_cast<std::size_t>(tx_end - tx_begin), {});
    if (y1 - y0 == kTileCells) fillWholeTiles(y0);
    for (int y = y0; y < y1; ++y)
      rows_.forEachSpan(y, [&](int x0, int x1) { fillSpan(y, x0, x1); });
  }

 private:
  /// Tiles that every row of the outline covers: most of them, and most of those are uniform, where
  /// the sum is another uniform tile and no cell is touched.
  void fillWholeTiles(int y0) {
    for (int y = y0; y < y0 + kTileCells; ++y)
      rows_.forEachSpan(y, [&](int x0, int x1) {
        const int end = x1 >> kTileBits;
        for (int tx = (x0 + kTileCells - 1) >> kTileBits; tx < end; ++tx) ++tileAt(tx).covered_rows;
      });
    for (std::size_t i = 0; i < tiles_.size(); ++i)
      if (tiles_[i].covered_rows == kTileCells) fillTile(tx_begin_ + static_cast<int>(i));
  }

  void fillTile(int tx) {
    const auto* tile = cells_.tile(tx, ty_);
    const auto value = tile ? Plane::uniformValue(tile) : std::optional<std::int8_t>(0);
    if (value && *value >= 0) {
      const int sum = std::min(*value + lanes_.amount(), int{kMostFree});
      if (sum != *value) cells_.setUniform(tx, ty_, static_cast<std::int8_t>(sum));
      return;
    }
    OpenTile& open = tileAt(tx);
    bool all_free = true;
    for (int y = 0; y < kTileCells; ++y) {
      fillPart(open, tx, ty_ * kTileCells + y, 0, kTileCells);
      all_free = all_free && allMostFree(open.read + y * kTileCells) &&
                 allMostFree(open.read + y * kTileCells + kLanes);
    }
    if (all_free) cells_.setUniform(tx, ty_, kMostFree);
  }

  void fillSpan(int y, int x0, int x1) {
    for (int x = x0; x < x1;) {
      const int tx = x >> kTileBits;
      const int base = tx * kTileCells;
      const int end = std::min(x1, base + kTileCells);
      OpenTile& tile = tileAt(tx);
      if (tile.covered_rows != kTileCells) fillPart(tile, tx, y, x - base, end - base);
      x = end;
    }
  }

  /// Cells [begin, end) of row y of the tile.
  void fillPart(OpenTile& tile, int tx, int y, int begin, int end) {
    static_assert(kTileCells == 2 * kLanes);
    const int row = (y & (kTileCells - 1)) << kTileBits;
    if (!tile.write && !openForChange(tile, tx, row, begin, end)) return;
    std::int8_t* cells = tile.write + row;
    unsigned freed = 0;
    if (begin < kLanes) freed = lanes_.add(cells, begin, std::min(end, kLanes));
    if (end > kLanes)
      freed |= lanes_.add(cells + kLanes, std::max(begin - kLanes, 0), end - kLanes) << kLanes;
    for (; freed != 0; freed &= freed - 1)
      freed_.push_back({tx * kTileCells + __builtin_ctz(freed), y});
  }

  /// False when the cells would not change: a shared tile then stays shared.
  bool openForChange(OpenTile& tile, int tx, int row, int begin, int end) {
    if (!tile.read) {
      if (const auto* t = cells_.tile(tx, ty_)) {
        tile.read = t->data();
        prefetch(tile.read);
      }
    }
    if (tile.read) {
      const std::int8_t* cells = tile.read + row;
      const bool left = begin < kLanes && lanes_.changes(cells, begin, std::min(end, kLanes));
      if (!left && !(end > kLanes &&
                     lanes_.changes(cells + kLanes, std::max(begin - kLanes, 0), end - kLanes)))
        return false;
    }
    tile.write = cells_.writeTile(tx, ty_).data();
    tile.read = tile.write;
    return true;
  }

  /// Rows are filled across tiles, so a tile's lines are asked for far apart.
  static void prefetch(const std::int8_t* tile) {
    constexpr int kCacheLine = 64;
    for (int i = kCacheLine; i < kTileCells * kTileCells; i += kCacheLine)
      __builtin_prefetch(tile + i);
  }

  OpenTile& tileAt(int tx) { return tiles_[static_cast<std::size_t>(tx - tx_begin_)]; }

  Plane& cells_;
  FillLanes lanes_;
  const PolygonRows& rows_;
  std::vector<Cell>& freed_;
  std::vector<OpenTile>& tiles_;
  int ty_ = 0;
  int tx_begin_ = 0;
};

void fillOutline(Plane& cells, std::int8_t amount, Scratch& scratch) {
  scratch.rows.build(scratch.outline);
  if (scratch.outline.empty()) return;
  const auto [left, right] =
      std::minmax_element(scratch.outline.begin(), scratch.outline.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  const int tx_begin = floorToInt(left->x) >> kTileBits;
  const int tx_end = (ceilToInt(right->x) >> kTileBits) + 1;
  TileRowFiller filler(cells, amount, scratch);
  const int end = scratch.rows.endRow();
  for (int y = scratch.rows.firstRow(); y < end;) {
    const int ty = y >> kTileBits;
    const int next = std::min((ty + 1) * kTileCells, end);
    filler.fill(ty, y, next, tx_begin, tx_end);
    y = next;
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
  CellReader before(cells_);
  for (const TPoint2D& p : shape.hits) {
    const TPoint2D v = toCells(p);
    const Cell cell{floorToInt(v.x), floorToInt(v.y)};
    scratch.hits.push_back({cell, before.at(cell)});
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
