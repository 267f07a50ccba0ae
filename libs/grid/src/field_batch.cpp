#include "ariadne/grid/field_batch.h"

#include <cmath>
#include <limits>

namespace ariadne::grid {
namespace {

using Plane = TiledPlane<std::uint8_t>;
using Two = double __attribute__((vector_size(16), aligned(8), may_alias));
using TwoWords = std::int64_t __attribute__((vector_size(16), aligned(8), may_alias));

/// Where four cells of the field, (0, 0) to (1, 1) from a given one, lie in memory. Remembers the
/// last tile: neighbouring beams end near each other.
class CornerFinder {
 public:
  explicit CornerFinder(const Plane& plane) : plane_(plane) {}

  /// The first of the cells when all are of one tile.
  const std::uint8_t* operator()(int x, int y) {
    constexpr int kLast = kTileCells - 1;
    if ((x & kLast) == kLast || (y & kLast) == kLast) return nullptr;
    const int tx = x >> kTileBits;
    const int ty = y >> kTileBits;
    if (tx != tx_ || ty != ty_ || !tile_) look(tx, ty);
    return tile_ + tileOffset(x, y);
  }

 private:
  void look(int tx, int ty) {
    static const Plane::Tile kNothing{};
    const Plane::Tile* tile = plane_.tile(tx, ty);
    tile_ = (tile ? tile : &kNothing)->data();
    tx_ = tx;
    ty_ = ty;
  }

  const Plane& plane_;
  const std::uint8_t* tile_ = nullptr;
  int tx_ = 0;
  int ty_ = 0;
};

std::uint16_t pair(const std::uint8_t* p) { return static_cast<std::uint16_t>(p[0] | p[1] << 8); }

std::uint32_t cornersAt(const std::uint8_t* p) {
  return pair(p) | std::uint32_t{pair(p + kTileCells)} << 16;
}

std::uint32_t cornersAcrossTiles(const Plane& plane, int x, int y) {
  return std::uint32_t{plane.at(x, y)} | std::uint32_t{plane.at(x + 1, y)} << 8 |
         std::uint32_t{plane.at(x, y + 1)} << 16 | std::uint32_t{plane.at(x + 1, y + 1)} << 24;
}

/// No cell's: x is farther than any.
constexpr std::int64_t kNoCell = std::numeric_limits<std::int64_t>::min();

/// Two coordinates in cells: which cells, in the low halves, and where in them.
struct TwoPlaces {
  TwoWords cell;
  Two within;
};

inline TwoPlaces split(Two u) {
  constexpr Two kFar = {1e9, 1e9};  // nothing is mapped so far out; it keeps cells within int
  constexpr Two kOne = {1, 1};
  // 1.5 * 2^52: what is added to it is rounded to whole numbers, and stands in the low bits.
  constexpr Two kRounder = {6755399441055744.0, 6755399441055744.0};
  u = u < kFar ? u : kFar;
  u = u > -kFar ? u : -kFar;
  const Two sum = u + kRounder;
  const Two nearest = sum - kRounder;
  const TwoWords over = nearest > u;
  return {reinterpret_cast<const TwoWords&>(sum) + over, u - (over ? nearest - kOne : nearest)};
}

inline Two& two(double* p) { return *reinterpret_cast<Two*>(p); }

double byteOf(std::uint32_t corners, int i) {
  return static_cast<double>(static_cast<int>(corners >> (8 * i) & 0xFFU));
}

}  // namespace

void FieldBatch::use(const OccupancyGrid& map, const std::vector<mrpt::math::TPoint2D>& points) {
  map_ = &map;
  points_ = &points;
  const std::size_t even = (points.size() + 1) / 2 * 2;
  for (auto* v : {&offset_x_, &offset_y_, &in_x_, &in_y_, &value_, &dx_, &dy_}) v->resize(even);
  cells_.assign(even, kNoCell);
  new_cells_.resize(even);
  corners_.resize(even);
  wanted_.resize(even);
}

void FieldBatch::turn(double heading) {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  double* __restrict x = offset_x_.data();
  double* __restrict y = offset_y_.data();
  for (const mrpt::math::TPoint2D& p : *points_) {
    *x++ = c * p.x - s * p.y;
    *y++ = s * p.x + c * p.y;
  }
}

void FieldBatch::findCorners(const mrpt::math::TPoint2D& at) {
  const double scale = 1 / map_->resolution();
  const double shift_x = -map_->origin().x * scale - 0.5;
  const double shift_y = -map_->origin().y * scale - 0.5;
  constexpr TwoWords kLowHalf = {0xFFFFFFFF, 0xFFFFFFFF};
  for (std::size_t i = 0; i < cells_.size(); i += 2) {
    const TwoPlaces x = split((at.x + two(&offset_x_[i])) * scale + shift_x);
    const TwoPlaces y = split((at.y + two(&offset_y_[i])) * scale + shift_y);
    *reinterpret_cast<TwoWords*>(&new_cells_[i]) = x.cell << 32 | (y.cell & kLowHalf);
    two(&in_x_[i]) = x.within;
    two(&in_y_[i]) = y.within;
  }
  readCorners();
}

/// Other particles have pushed this one's field out of the cache: all that is wanted is named
/// before any of it is read.
void FieldBatch::readCorners() {
  CornerFinder find(map_->field());
  std::size_t wanted = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const std::int64_t cell = new_cells_[i];
    if (cell == cells_[i]) continue;
    cells_[i] = cell;
    const int x = static_cast<int>(cell >> 32);
    const int y = static_cast<int>(cell);
    if (const std::uint8_t* p = find(x, y)) {
      __builtin_prefetch(p);
      __builtin_prefetch(p + kTileCells);
      wanted_[wanted++] = {p, i};
    } else {
      corners_[i] = cornersAcrossTiles(map_->field(), x, y);
    }
  }
  for (std::size_t k = 0; k < wanted; ++k)
    corners_[wanted_[k].second] = cornersAt(wanted_[k].first);
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
