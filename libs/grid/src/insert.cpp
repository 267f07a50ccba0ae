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
        amount_(amount),
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
      const int sum = std::min(*value + amount_, int{kMostFree});
      if (sum != *value) cells_.setUniform(tx, ty_, static_cast<std::int8_t>(sum));
      return;
    }
    bool all_free = true;
    for (int y = 0; y < kTileCells; ++y)
      for (int x = 0; x < kTileCells; x += kLanes) {
        fillLanes(tx, tx * kTileCells + x, ty_ * kTileCells + y, 0, kLanes);
        all_free &= allMostFree(tileAt(tx).read + Plane::offset(x, y));
      }
    if (all_free) cells_.setUniform(tx, ty_, kMostFree);
  }

  void fillSpan(int y, int x0, int x1) {
    for (int tx = x0 >> kTileBits; tx <= (x1 - 1) >> kTileBits; ++tx) {
      if (tileAt(tx).covered_rows == kTileCells) continue;
      const int base = tx * kTileCells;
      const int begin = std::max(x0 - base, 0);
      const int end = std::min(x1 - base, kTileCells);
      for (int half = begin & ~(kLanes - 1); half < end; half += kLanes)
        fillLanes(tx, base + half, y, std::max(begin - half, 0), std::min(end - half, kLanes));
    }
  }

  OpenTile& tileAt(int tx) { return tiles_[static_cast<std::size_t>(tx - tx_begin_)]; }
  OpenTile& open(int tx) {
    OpenTile& tile = tileAt(tx);
    if (!tile.read) {
      const auto* t = cells_.tile(tx, ty_);
      if (t) {
        tile.read = t->data();
        prefetch(tile.read);
      } else {
        makeWritable(tx, tile);
      }
    }
    return tile;
  }
  /// Rows are filled across tiles, so a tile's lines are asked for far apart; the waiting was a
  /// quarter of a run.
  static void prefetch(const std::int8_t* tile) {
    constexpr int kCacheLine = 64;
    for (int i = kCacheLine; i < kTileCells * kTileCells; i += kCacheLine)
      __builtin_prefetch(tile + i);
  }
  void makeWritable(int tx, OpenTile& tile) {
    tile.write = cells_.writeTile(tx, ty_).data();
    tile.read = tile.write;
  }
  /// Lanes [begin, end) of the sixteen cells from (x, y) on.
  void fillLanes(int tx, int x, int y, int begin, int end) {
    OpenTile& tile = open(tx);
    const int offset = Plane::offset(x, y);
    const FillLanes lanes(begin, end, amount_);
    if (!tile.write) {
      if (!lanes.changes(tile.read + offset)) return;
      makeWritable(tx, tile);
    }
    for (unsigned bits = lanes.apply(tile.write + offset); bits != 0; bits &= bits - 1)
      freed_.push_back({x + __builtin_ctz(bits), y});
  }

  Plane& cells_;
  std::int8_t amount_;
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
