#include "ariadne/grid/free_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ariadne::grid {
namespace {

// 99 / 70 is the square root of two to four digits; whole numbers allow a queue of buckets.
constexpr int kStraight = 70;
constexpr int kDiagonal = 99;

/// Cells within `reach` cells of one that is not free, as a window of side x side.
class Clearance {
 public:
  Clearance(const OccupancyGrid& map, Cell corner, int side, double reach)
      : side_(side), reach_(static_cast<int>(reach)), blocked_(area(), 0), nearest_(area()) {
    for (int y = 0; y < side; ++y) rowDistances(map, corner, y);
    for (int dy = -reach_; dy <= reach_; ++dy) {
      const int dx = static_cast<int>(std::sqrt(std::max(0.0, reach * reach - dy * dy)));
      for (int y = std::max(0, -dy); y < std::min(side, side - dy); ++y) spread(y + dy, y, dx);
    }
  }
  const std::vector<std::uint8_t>& blocked() const { return blocked_; }

 private:
  std::size_t area() const { return static_cast<std::size_t>(side_) * side_; }

  /// For every cell of the row how far along it the next cell lies that is not free, at most
  /// reach_ + 1.
  void rowDistances(const OccupancyGrid& map, Cell corner, int y) {
    std::uint8_t* row = &nearest_[static_cast<std::size_t>(y) * side_];
    const std::vector<std::uint8_t> free = freeRow(map, corner.x - reach_, corner.y + y);
    const int far = reach_ + 1;
    const int last = side_ + 2 * reach_;
    int d = far;
    for (int i = 0; i < last - reach_; ++i) {
      d = free[i] ? std::min(d + 1, far) : 0;
      if (i >= reach_) row[i - reach_] = static_cast<std::uint8_t>(d);
    }
    d = far;
    for (int i = last; i-- > reach_;) {
      d = free[i] ? std::min(d + 1, far) : 0;
      if (i < last - reach_)
        row[i - reach_] = static_cast<std::uint8_t>(std::min<int>(d, row[i - reach_]));
    }
  }
  /// Whether cells are free, from x0 on; tiles are looked up once, not cell by cell.
  std::vector<std::uint8_t> freeRow(const OccupancyGrid& map, int x0, int y) const {
    std::vector<std::uint8_t> free(static_cast<std::size_t>(side_ + 2 * reach_), 0);
    const int x1 = x0 + side_ + 2 * reach_;
    for (int x = x0; x < x1;) {
      const int end = std::min(x1, ((x >> kTileBits) + 1) * kTileCells);
      if (const auto* tile = map.cells().tile(x >> kTileBits, y >> kTileBits))
        for (int i = x; i < end; ++i)
          free[i - x0] = (*tile)[TiledPlane<std::int8_t>::offset(i, y)] > 0;
      x = end;
    }
    return free;
  }
  void spread(int from_row, int to_row, int dx) {
    const std::uint8_t* from = &nearest_[static_cast<std::size_t>(from_row) * side_];
    std::uint8_t* to = &blocked_[static_cast<std::size_t>(to_row) * side_];
    for (int x = 0; x < side_; ++x) to[x] |= static_cast<std::uint8_t>(from[x] <= dx);
  }

  int side_;
  int reach_;
  std::vector<std::uint8_t> blocked_;
  std::vector<std::uint8_t> nearest_;
};

}  // namespace

FreeDistance::FreeDistance(const OccupancyGrid& map, const mrpt::math::TPoint2D& from,
                           double limit_m, double robot_radius_m)
    : map_(map),
      resolution_(map.resolution()),
      robot_radius_m_(robot_radius_m),
      limit_units_(static_cast<std::int32_t>(kStraight * limit_m / resolution_)) {
  const double reach = robot_radius_m / resolution_;
  // The window has one row more all around, never open, so that neighbours need no bounds.
  const int half = static_cast<int>(limit_m / resolution_) + 2;
  const Cell start = map.cellOf(from);
  corner_ = {start.x - half, start.y - half};
  side_ = 2 * half + 1;
  const Clearance clearance(map, corner_, side_, std::min(reach, 250.0));
  open_.assign(clearance.blocked().size(), 0);
  for (int y = 1; y < side_ - 1; ++y)
    for (int x = 1; x < side_ - 1; ++x) {
      const int i = y * side_ + x;
      const bool leaving = std::abs(x - half) <= reach && std::hypot(x - half, y - half) <= reach;
      open_[i] = leaving ? map.at({corner_.x + x, corner_.y + y}) > 0 : !clearance.blocked()[i];
    }
  units_.assign(open_.size(), -1);
  search(half * side_ + half);
}

// Dijkstra with a ring of buckets (Dial, 1969): all steps are shorter than the ring.
void FreeDistance::search(int start) {
  std::array<std::vector<std::pair<std::int32_t, int>>, kDiagonal + 1> ring;
  const std::array<std::pair<int, int>, 8> steps{{{1, kStraight},
                                                  {-1, kStraight},
                                                  {side_, kStraight},
                                                  {-side_, kStraight},
                                                  {side_ + 1, kDiagonal},
                                                  {side_ - 1, kDiagonal},
                                                  {-side_ + 1, kDiagonal},
                                                  {-side_ - 1, kDiagonal}}};
  units_[start] = 0;
  ring[0].emplace_back(0, start);
  std::size_t waiting = 1;
  for (std::int32_t now = 0; waiting > 0; ++now) {
    auto& bucket = ring[now % ring.size()];
    for (std::size_t k = 0; k < bucket.size(); ++k) {
      const auto [length, cell] = bucket[k];
      --waiting;
      if (length != units_[cell]) continue;  // reached on a shorter way meanwhile
      for (const auto& [offset, cost] : steps) {
        const int next = cell + offset;
        const std::int32_t reached = length + cost;
        if (!open_[next] || reached > limit_units_) continue;
        if (units_[next] >= 0 && units_[next] <= reached) continue;
        units_[next] = reached;
        ring[reached % ring.size()].emplace_back(reached, next);
        ++waiting;
      }
    }
    bucket.clear();
  }
}

int FreeDistance::index(Cell c) const {
  const int x = c.x - corner_.x;
  const int y = c.y - corner_.y;
  return x < 0 || y < 0 || x >= side_ || y >= side_ ? -1 : y * side_ + x;
}

std::optional<double> FreeDistance::to(const mrpt::math::TPoint2D& to) const {
  const int i = index(map_.cellOf(to));
  if (i < 0 || units_[i] < 0) return std::nullopt;
  return units_[i] * resolution_ / kStraight;
}

std::optional<double> FreeDistance::toPlace(const mrpt::math::TPoint2D& to) const {
  const Cell centre = map_.cellOf(to);
  const int reach = static_cast<int>(robot_radius_m_ / resolution_);
  std::optional<double> best;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const double rest = std::hypot(dx, dy);
      const int i = index({centre.x + dx, centre.y + dy});
      if (rest > reach || i < 0 || units_[i] < 0) continue;
      const double length = (static_cast<double>(units_[i]) / kStraight + rest) * resolution_;
      if (!best || length < *best) best = length;
    }
  return best;
}

}  // namespace ariadne::grid
