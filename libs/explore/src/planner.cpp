#include "ariadne/explore/planner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ariadne::explore {
namespace {

// 99 / 70 is the square root of two to four digits; whole numbers allow a queue of buckets.
constexpr int kStraight = 70;
constexpr int kDiagonal = 99;
constexpr int kWorstFactor = 3;  // of a route beside walls

}  // namespace

Planner::Planner(std::shared_ptr<const PlanningGrid> grid, const mrpt::math::TPoint2D& robot,
                 const ExploreParams& params)
    : grid_(std::move(grid)),
      preferred_m_(params.robot_radius_m + params.preferred_clearance_m),
      open_(static_cast<std::size_t>(grid_->size()), 0),
      cost_(open_.size(), -1),
      before_(open_.size(), -1) {
  const int start = grid_->indexOf(robot);
  markOpen(params, start);
  if (start >= 0) search(start);
}

void Planner::markOpen(const ExploreParams& params, int start) {
  // Distances are between centres; a wall's face is half a cell nearer.
  const double wall = params.robot_radius_m + params.clearance_m + grid_->cell_m() / 2;
  const int w = grid_->width();
  for (int y = 1; y < grid_->height() - 1; ++y)
    for (int i = y * w + 1; i < (y + 1) * w - 1; ++i)
      open_[i] = grid_->kind(i) == CellKind::free && grid_->wallDistance(i) >= wall &&
                 grid_->unknownDistance(i) >= params.robot_radius_m;
  if (start < 0) return;
  // Out of a place too near to a wall, but never nearer to it.
  const double least = std::min(wall, grid_->wallDistance(start));
  const int reach = static_cast<int>(std::ceil(wall / grid_->cell_m())) + 1;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const int x = start % w + dx;
      const int y = start / w + dy;
      if (x < 1 || y < 1 || x >= w - 1 || y >= grid_->height() - 1) continue;
      const int i = y * w + x;
      if (std::hypot(dx, dy) <= reach && grid_->kind(i) == CellKind::free &&
          grid_->wallDistance(i) >= least)
        open_[i] = 1;
    }
  open_[start] = 1;
}

int Planner::penalised(int step, int cell) const {
  const double wall = grid_->wallDistance(cell);
  if (wall >= preferred_m_) return step;
  return static_cast<int>(step * (1 + (kWorstFactor - 1) * (1 - wall / preferred_m_)));
}

// Dijkstra with a ring of buckets (Dial, 1969): all steps are shorter than the ring.
void Planner::search(int start) {
  const int w = grid_->width();
  const std::array<std::pair<int, int>, 8> steps{{{1, kStraight},
                                                  {-1, kStraight},
                                                  {w, kStraight},
                                                  {-w, kStraight},
                                                  {w + 1, kDiagonal},
                                                  {w - 1, kDiagonal},
                                                  {-w + 1, kDiagonal},
                                                  {-w - 1, kDiagonal}}};
  std::array<std::vector<std::pair<int, int>>, kWorstFactor * kDiagonal + 1> ring;
  cost_[start] = 0;
  ring[0].emplace_back(0, start);
  std::size_t waiting = 1;
  for (int now = 0; waiting > 0; ++now) {
    auto& bucket = ring[static_cast<std::size_t>(now) % ring.size()];
    for (std::size_t k = 0; k < bucket.size(); ++k) {
      const auto [cost, cell] = bucket[k];
      --waiting;
      if (cost != cost_[cell]) continue;  // reached on a cheaper route meanwhile
      for (const auto& [offset, step] : steps) {
        const int next = cell + offset;
        if (!open_[next]) continue;
        const int reached = cost + penalised(step, next);
        if (cost_[next] >= 0 && cost_[next] <= reached) continue;
        cost_[next] = reached;
        before_[next] = cell;
        ring[static_cast<std::size_t>(reached) % ring.size()].emplace_back(reached, next);
        ++waiting;
      }
    }
    bucket.clear();
  }
}

double Planner::length(int cell) const {
  int units = 0;
  for (int i = cell; before_[i] >= 0; i = before_[i]) {
    const int offset = std::abs(i - before_[i]);
    units += offset == 1 || offset == grid_->width() ? kStraight : kDiagonal;
  }
  return units * grid_->cell_m() / kStraight;
}

Route Planner::routeTo(int cell) const {
  Route route;
  for (int i = cell; i >= 0; i = before_[i]) route.push_back(grid_->centreOf(i));
  std::reverse(route.begin(), route.end());
  return route;
}

int Planner::nearestTo(const mrpt::math::TPoint2D& point, double radius_m) const {
  const int centre = grid_->indexOf(point);
  if (centre < 0) return -1;
  const int w = grid_->width();
  const int reach = static_cast<int>(radius_m / grid_->cell_m());
  int best = -1;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const int x = centre % w + dx;
      const int y = centre / w + dy;
      if (std::hypot(dx, dy) > reach || x < 1 || y < 1 || x >= w - 1 || y >= grid_->height() - 1)
        continue;
      const int i = y * w + x;
      if (!reaches(i) || (best >= 0 && cost_[i] >= cost_[best])) continue;
      if (i == centre || grid_->sees(i, centre)) best = i;
    }
  return best;
}

}  // namespace ariadne::explore
