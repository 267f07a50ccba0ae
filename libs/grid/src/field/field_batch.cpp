#include "ariadne/grid/field/field_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "field/two_doubles.h"

namespace ariadne::grid {
namespace {

using Plane = LikelihoodField::Plane;

std::uint16_t pair(const std::uint8_t* p) { return static_cast<std::uint16_t>(p[0] | p[1] << 8); }

/// The bits of a cell that say in which tile of the field it is.
constexpr std::int64_t kTileOfCell =
    ~(std::int64_t{kTileCells - 1} << 32 | std::int64_t{Plane::kRows - 1});
/// No cell's: x is farther than any.
constexpr std::int64_t kNoCell = std::numeric_limits<std::int64_t>::min();

std::int64_t cellAt(int x, int y) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << 32 |
                                   static_cast<std::uint32_t>(y));
}

/// Two coordinates in cells: which cells, in the low halves, and where in them.
struct TwoPlaces {
  TwoInts cell;
  TwoDoubles within;
};

/// |u| must be under 2^31.
inline TwoPlaces split(TwoDoubles u) {
  constexpr TwoDoubles kOne = {1, 1};
  TwoInts cell;
  const TwoDoubles nearest = rounded(u, cell);
  const TwoInts over = nearest > u;  // -1 where it is
  const TwoInts one_over = over & reinterpret_cast<const TwoInts&>(kOne);
  return {cell + over, u - (nearest - reinterpret_cast<const TwoDoubles&>(one_over))};
}

double byteOf(std::uint32_t corners, int i) {
  return static_cast<double>(static_cast<int>(corners >> (8 * i) & 0xFFU));
}

}  // namespace

void FieldBatch::use(const OccupancyGrid& map, const std::vector<mrpt::math::TPoint2D>& points) {
  map_ = &map;
  points_ = &points;
  const std::size_t even = (points.size() + 1) / 2 * 2;
  for (auto* v : {&offset_x_, &offset_y_, &in_x_, &in_y_, &value_, &dx_, &dy_}) v->resize(even, 0);
  cells_.assign(even, kNoCell);
  tiles_.fill({kNoCell, nullptr});
  new_cells_.resize(even);
  corners_.resize(even);
  wanted_.resize(even);
}

void FieldBatch::turn(double heading) {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  headed_ = std::isfinite(heading);
  double* __restrict x = offset_x_.data();
  double* __restrict y = offset_y_.data();
  for (const mrpt::math::TPoint2D& p : *points_) {
    *x++ = c * p.x - s * p.y;
    *y++ = s * p.x + c * p.y;
  }
}

void FieldBatch::findCorners(const mrpt::math::TPoint2D& at) {
  const double scale = 1 / map_->resolution();
  const double x0 = (at.x - map_->origin().x) * scale;
  const double y0 = (at.y - map_->origin().y) * scale;
  constexpr double kFar = 1e9;  // nothing is mapped so far out; it keeps cells within int
  if (!(std::abs(x0) < kFar && std::abs(y0) < kFar) || !headed_) {
    std::fill(corners_.begin(), corners_.end(), 0);
    std::fill(cells_.begin(), cells_.end(), kNoCell);
    return;
  }
  const double shift_x = -map_->origin().x * scale - 0.5;
  const double shift_y = -map_->origin().y * scale - 0.5;
  constexpr TwoInts kLowHalf = {0xFFFFFFFF, 0xFFFFFFFF};
  const TwoDoubles at_x = {at.x, at.x};
  const TwoDoubles at_y = {at.y, at.y};
  // Named here: in the loop every write would have these be looked up again.
  const double* __restrict offset_x = offset_x_.data();
  const double* __restrict offset_y = offset_y_.data();
  std::int64_t* __restrict cells = new_cells_.data();
  double* __restrict in_x = in_x_.data();
  double* __restrict in_y = in_y_.data();
  const std::size_t n = cells_.size();
  for (std::size_t i = 0; i < n; i += 2) {
    const TwoPlaces x = split((at_x + twoAt(offset_x + i)) * scale + shift_x);
    const TwoPlaces y = split((at_y + twoAt(offset_y + i)) * scale + shift_y);
    *reinterpret_cast<TwoInts*>(cells + i) = x.cell << 32 | (y.cell & kLowHalf);
    twoAt(in_x + i) = x.within;
    twoAt(in_y + i) = y.within;
  }
  readCorners();
}

/// The tile of a cell; one of zeros where there is none.
inline const std::uint8_t* FieldBatch::tileOf(std::int64_t cell) {
  const std::int64_t tile = cell & kTileOfCell;
  const std::uint64_t place =
      static_cast<std::uint64_t>(tile) * 0x9E3779B97F4A7C15U >> (64 - kKnownBits);
  KnownTile& known = tiles_[place];
  if (known.tile != tile) known = {tile, lookUp(tile)};
  return known.cells;
}

const std::uint8_t* FieldBatch::lookUp(std::int64_t tile) const {
  static const Plane::Tile kNothing{};
  const Plane::Tile* found = map_->field().tile(static_cast<int>(tile >> 32) >> kTileBits,
                                                static_cast<int>(tile) >> Plane::kRowBits);
  return (found ? found : &kNothing)->data();
}

std::uint32_t FieldBatch::cornersAcrossTiles(int x, int y) {
  const auto byte = [&](int cx, int cy) {
    return std::uint32_t{tileOf(cellAt(cx, cy))[Plane::offset(cx, cy)]};
  };
  return byte(x, y) | byte(x + 1, y) << 8 | byte(x, y + 1) << 16 | byte(x + 1, y + 1) << 24;
}

/// Other particles have pushed this one's field out of the cache: all that is wanted is named
/// before any of it is read.
void FieldBatch::readCorners() {
  constexpr int kLastColumn = kTileCells - 1;
  constexpr int kLastRow = Plane::kRows - 1;
  const std::size_t n = size();
  const std::int64_t* __restrict now = new_cells_.data();
  std::int64_t* __restrict cells = cells_.data();
  std::uint32_t* __restrict corners = corners_.data();
  Wanted* __restrict wanted = wanted_.data();
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t cell = now[i];
    if (cell == cells[i]) continue;
    cells[i] = cell;
    const int x = static_cast<int>(cell >> 32);
    const int y = static_cast<int>(cell);
    if ((x & kLastColumn) == kLastColumn) {
      corners[i] = cornersAcrossTiles(x, y);
      continue;
    }
    const std::uint8_t* low = tileOf(cell) + Plane::offset(x, y);
    const std::uint8_t* high = (y & kLastRow) != kLastRow
                                   ? low + kTileCells
                                   : tileOf(cellAt(x, y + 1)) + Plane::offset(x, y + 1);
    __builtin_prefetch(low);
    __builtin_prefetch(high);
    wanted[count++] = {low, high, i};
  }
  for (std::size_t k = 0; k < count; ++k)
    corners[wanted[k].point] = pair(wanted[k].low) | std::uint32_t{pair(wanted[k].high)} << 16;
}

void FieldBatch::sample(const mrpt::math::TPoint2D& at) {
  findCorners(at);
  const double scale = 1 / map_->resolution() / 255;
  const std::uint32_t* __restrict corners = corners_.data();
  const double* __restrict in_x = in_x_.data();
  const double* __restrict in_y = in_y_.data();
  double* __restrict value = value_.data();
  double* __restrict dx = dx_.data();
  double* __restrict dy = dy_.data();
  for (std::size_t i = 0; i < value_.size(); ++i) {
    const double v00 = byteOf(corners[i], 0);
    const double v10 = byteOf(corners[i], 1);
    const double v01 = byteOf(corners[i], 2);
    const double v11 = byteOf(corners[i], 3);
    const double low = v00 * (1 - in_x[i]) + v10 * in_x[i];
    const double high = v01 * (1 - in_x[i]) + v11 * in_x[i];
    value[i] = (low * (1 - in_y[i]) + high * in_y[i]) / 255;
    dx[i] = ((v10 - v00) * (1 - in_y[i]) + (v11 - v01) * in_y[i]) * scale;
    dy[i] = (high - low) * scale;
  }
}

double FieldBatch::sum(const mrpt::math::TPoint2D& at) {
  findCorners(at);
  const std::uint32_t* __restrict corners = corners_.data();
  const double* __restrict in_x = in_x_.data();
  const double* __restrict in_y = in_y_.data();
  double* __restrict value = value_.data();
  for (std::size_t i = 0; i < value_.size(); ++i) {
    const double low = byteOf(corners[i], 0) * (1 - in_x[i]) + byteOf(corners[i], 1) * in_x[i];
    const double high = byteOf(corners[i], 2) * (1 - in_x[i]) + byteOf(corners[i], 3) * in_x[i];
    value[i] = low * (1 - in_y[i]) + high * in_y[i];
  }
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += value[i];
  return sum;
}

}  // namespace ariadne::grid
