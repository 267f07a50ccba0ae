#include "ariadne/grid/queries/free_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ariadne::grid {
namespace {

// 99 / 70 is the square root of two to four digits; whole numbers allow a queue of buckets.
constexpr int kStraight = 70;
constexpr int kDiagonal = 99;
constexpr double kMostReach = 250;  // cells; distances along rows are bytes
// In place of a length. A blocked cell is less than any, so that no path into it is shorter.
constexpr std::int32_t kBlocked = -1;
constexpr std::int32_t kUnreached = std::numeric_limits<std::int32_t>::max();

/// Cells within `reach` cells of one that is not free, as a window.
class Clearance {
 public:
  Clearance(const OccupancyGrid& map, Cell corner, int width, int height, double reach)
      : width_(width),
        height_(height),
        reach_(static_cast<int>(reach)),
        blocked_(area(), 0),
        nearest_(area()) {
    for (int y = 0; y < height; ++y) rowDistances(map, corner, y);
    for (int dy = -reach_; dy <= reach_; ++dy) {
      const int dx = static_cast<int>(std::sqrt(std::max(0.0, reach * reach - dy * dy)));
      for (int y = std::max(0, -dy); y < std::min(height, height - dy); ++y) spread(y + dy, y, dx);
    }
  }
  const std::vector<std::uint8_t>& blocked() const { return blocked_; }

 private:
  std::size_t area() const { return static_cast<std::size_t>(width_) * height_; }

  /// For every cell of the row how far along it the next cell lies that is not free, at most
  /// reach_ + 1.
  void rowDistances(const OccupancyGrid& map, Cell corner, int y) {
    std::uint8_t* row = &nearest_[static_cast<std::size_t>(y) * width_];
    const std::vector<std::uint8_t> free = freeRow(map, corner.x - reach_, corner.y + y);
    const int far = reach_ + 1;
    const int last = width_ + 2 * reach_;
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
    std::vector<std::uint8_t> free(static_cast<std::size_t>(width_ + 2 * reach_), 0);
    const int x1 = x0 + width_ + 2 * reach_;
    for (int x = x0; x < x1;) {
      const int end = std::min(x1, ((x >> kTileBits) + 1) * kTileCells);
      if (const auto* tile = map.cells().tile(x >> kTileBits, y >> kTileBits)) {
        const std::uint32_t row = tile->freeRow(y & (kTileCells - 1));
        for (int i = x; i < end; ++i) free[i - x0] = row >> (i & (kTileCells - 1)) & 1U;
      }
      x = end;
    }
    return free;
  }
  void spread(int from_row, int to_row, int dx) {
    const std::uint8_t* from = &nearest_[static_cast<std::size_t>(from_row) * width_];
    std::uint8_t* to = &blocked_[static_cast<std::size_t>(to_row) * width_];
    for (int x = 0; x < width_; ++x) to[x] |= static_cast<std::uint8_t>(from[x] <= dx);
  }

  int width_;
  int height_;
  int reach_;
  std::vector<std::uint8_t> blocked_;
  std::vector<std::uint8_t> nearest_;
};

struct Box {
  double x0, x1, y0, y1;
};

/// Where the paths from `from` lie that are no longer than the limit: all of them, or those to the
/// targets. A path of length l to b keeps to the ellipse |p - from| + |p - b| <= l.
Box boxOfPaths(const mrpt::math::TPoint2D& from, double limit_m,
               const std::vector<mrpt::math::TPoint2D>& targets) {
  if (targets.empty())
    return {from.x - limit_m, from.x + limit_m, from.y - limit_m, from.y + limit_m};
  Box box{from.x, from.x, from.y, from.y};
  for (const auto& to : targets) {
    // Half extents of an ellipse of major axis l: sqrt(l^2 - d^2 + dx^2) / 2 along x, d between
    // foci.
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double rest = std::max(0.0, limit_m * limit_m - dx * dx - dy * dy);
    const double half_x = std::sqrt(rest + dx * dx) / 2;
    const double half_y = std::sqrt(rest + dy * dy) / 2;
    box.x0 = std::min(box.x0, from.x + dx / 2 - half_x);
    box.x1 = std::max(box.x1, from.x + dx / 2 + half_x);
    box.y0 = std::min(box.y0, from.y + dy / 2 - half_y);
    box.y1 = std::max(box.y1, from.y + dy / 2 + half_y);
  }
  return box;
}

}  // namespace

FreeDistance::FreeDistance(const OccupancyGrid& map, const mrpt::math::TPoint2D& from,
                           double limit_m, double robot_radius_m,
                           const std::vector<mrpt::math::TPoint2D>& targets)
    : map_(map),
      resolution_(map.resolution()),
      robot_radius_m_(robot_radius_m),
      limit_units_(static_cast<std::int32_t>(kStraight * limit_m / resolution_)) {
  // The window has one row more all around, never open, so that neighbours need no bounds; and as
  // many below and above as a wall's clearance reaches (within a row Clearance looks farther).
  const int margin = 2 + static_cast<int>(std::min(robot_radius_m / resolution_, kMostReach));
  // Paths are between centres of cells, half a diagonal from the points at the most.
  const Box box = boxOfPaths(from, limit_m + 2 * resolution_, targets);
  const Cell low = map.cellOf({box.x0, box.y0});
  const Cell high = map.cellOf({box.x1, box.y1});
  corner_ = {low.x - 2, low.y - margin};
  width_ = high.x - low.x + 5;
  height_ = high.y - low.y + 2 * margin + 1;
  const Cell start = map.cellOf(from);
  openCells(start);
  search(index(start));
}

/// Marks the cells that may be entered kUnreached, all others kBlocked.
void FreeDistance::openCells(Cell start) {
  const double reach = robot_radius_m_ / resolution_;
  const Clearance clearance(map_, corner_, width_, height_, std::min(reach, kMostReach));
  units_.resize(clearance.blocked().size());
  for (std::size_t i = 0; i < units_.size(); ++i)
    units_[i] = clearance.blocked()[i] != 0 ? kBlocked : kUnreached;
  const int r = static_cast<int>(reach);
  for (int dy = -r; dy <= r; ++dy)
    for (int dx = -r; dx <= r; ++dx) {
      const Cell c{start.x + dx, start.y + dy};
      const int i = index(c);
      if (i >= 0 && std::hypot(dx, dy) <= reach) units_[i] = map_.at(c) > 0 ? kUnreached : kBlocked;
    }
  std::fill_n(units_.begin(), width_, kBlocked);
  std::fill_n(units_.end() - width_, width_, kBlocked);
  for (int y = 0; y < height_; ++y) units_[y * width_] = units_[y * width_ + width_ - 1] = kBlocked;
}

// Dijkstra with a ring of buckets (Dial, 1969): all steps are shorter than the ring.
void FreeDistance::search(int start) {
  std::array<std::vector<std::pair<std::int32_t, int>>, kDiagonal + 1> ring;
  const std::array<std::pair<int, int>, 8> steps{{{1, kStraight},
                                                  {-1, kStraight},
                                                  {width_, kStraight},
                                                  {-width_, kStraight},
                                                  {width_ + 1, kDiagonal},
                                                  {width_ - 1, kDiagonal},
                                                  {-width_ + 1, kDiagonal},
                                                  {-width_ - 1, kDiagonal}}};
  units_[start] = 0;
  ring[0].emplace_back(0, start);
  std::size_t waiting = 1;
  for (std::int32_t now = 0; waiting > 0; ++now) {
    auto& bucket = ring[now % ring.size()];
    for (std::size_t k = 0; k < bucket.size(); ++k) {
      const auto [length, cell] = bucket[k];
      --waiting;
      if (length != units_[cell]) continue;  // reached on a shorter path meanwhile
      for (const auto& [offset, cost] : steps) {
        const int next = cell + offset;
        const std::int32_t reached = length + cost;
        if (units_[next] <= reached || reached > limit_units_) continue;
        units_[next] = reached;
        ring[reached % ring.size()].emplace_back(reached, next);
        ++waiting;
      }
    }
    bucket.clear();
  }
}

bool FreeDistance::isReached(int i) const {
  return i >= 0 && units_[i] != kBlocked && units_[i] != kUnreached;
}

int FreeDistance::index(Cell c) const {
  const int x = c.x - corner_.x;
  const int y = c.y - corner_.y;
  return x < 0 || y < 0 || x >= width_ || y >= height_ ? -1 : y * width_ + x;
}

std::optional<double> FreeDistance::to(const mrpt::math::TPoint2D& to) const {
  const int i = index(map_.cellOf(to));
  if (!isReached(i)) return std::nullopt;
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
      if (rest > reach || !isReached(i)) continue;
      const double length = (static_cast<double>(units_[i]) / kStraight + rest) * resolution_;
      if (!best || length < *best) best = length;
    }
  return best;
}

}  // namespace ariadne::grid
