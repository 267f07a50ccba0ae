#include "ariadne/explore/frontiers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

using mrpt::math::TPoint2D;

constexpr double kFailedRadius_m = 0.6;

/// Nearer to a wall than its radius the robot's centre cannot pass; and there the wall itself has
/// gaps where beams grazed it.
bool isFrontier(const PlanningGrid& grid, int cell, double robot_radius_m) {
  if (grid.kind(cell) != CellKind::free || grid.wallDistance(cell) < robot_radius_m) return false;
  const int w = grid.width();
  const std::array<int, 4> beside{cell - 1, cell + 1, cell - w, cell + w};
  return std::any_of(beside.begin(), beside.end(),
                     [&](int i) { return grid.kind(i) == CellKind::unknown; });
}

/// All cells that hang together with `first` over edges and corners; takes them out of `marked`.
std::vector<int> cluster(int first, int width, std::vector<std::uint8_t>& marked) {
  std::vector<int> cells{first};
  marked[first] = 0;
  for (std::size_t k = 0; k < cells.size(); ++k)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int next = cells[k] + dy * width + dx;
        if (!marked[next]) continue;
        marked[next] = 0;
        cells.push_back(next);
      }
  return cells;
}

double diagonal(const std::vector<int>& cells, const PlanningGrid& grid) {
  int x0 = grid.width();
  int x1 = 0;
  int y0 = grid.height();
  int y1 = 0;
  for (const int c : cells) {
    x0 = std::min(x0, c % grid.width());
    x1 = std::max(x1, c % grid.width());
    y0 = std::min(y0, c / grid.width());
    y1 = std::max(y1, c / grid.width());
  }
  return std::hypot(x1 - x0, y1 - y0) * grid.cell_m();
}

/// Finds where to stand for the nearest cell that has not failed, or why there is no such place.
void approach(Frontier& f, const std::vector<int>& cells, const Planner& planner,
              const ExploreParams& params, const std::vector<FailedTarget>& failed) {
  const double reach_m = params.robot_radius_m + params.clearance_m + 2.5 * planner.grid().cell_m();
  const FailedTarget* near_failed = nullptr;
  for (const int c : cells) {
    const TPoint2D centre = planner.grid().centreOf(c);
    const auto fail = std::find_if(failed.begin(), failed.end(), [&](const FailedTarget& t) {
      return geometry::distance(t.at, centre) < kFailedRadius_m;
    });
    if (fail != failed.end()) {
      near_failed = &*fail;
      continue;
    }
    const int stand = planner.nearestTo(centre, reach_m);
    if (stand < 0 || (f.stand >= 0 && planner.cost(stand) >= planner.cost(f.stand))) continue;
    f.stand = stand;
    f.target = centre;
  }
  if (f.stand >= 0)
    f.route_m = planner.length(f.stand);
  else
    f.left = near_failed ? near_failed->why : "no route leads there";
}

}  // namespace

std::vector<Frontier> findFrontiers(const Planner& planner, const ExploreParams& params,
                                    const std::vector<FailedTarget>& failed) {
  const PlanningGrid& grid = planner.grid();
  std::vector<std::uint8_t> marked(static_cast<std::size_t>(grid.size()), 0);
  for (int y = 1; y < grid.height() - 1; ++y)
    for (int i = y * grid.width() + 1; i < (y + 1) * grid.width() - 1; ++i)
      marked[i] = isFrontier(grid, i, params.robot_radius_m);
  std::vector<Frontier> frontiers;
  for (int i = 0; i < grid.size(); ++i) {
    if (!marked[i]) continue;
    const std::vector<int> cells = cluster(i, grid.width(), marked);
    Frontier f;
    for (const int c : cells) f.cells.push_back(grid.centreOf(c));
    f.width_m = diagonal(cells, grid);
    f.target = f.cells[f.cells.size() / 2];
    if (f.width_m < 2 * params.robot_radius_m)
      f.left = "narrower than the robot";
    else
      approach(f, cells, planner, params, failed);
    frontiers.push_back(std::move(f));
  }
  return frontiers;
}

std::optional<std::size_t> chooseFrontier(const std::vector<Frontier>& frontiers,
                                          const ExploreParams& params) {
  const auto cost = [&](const Frontier& f) {
    return params.frontier_choice == FrontierChoice::nearest
               ? f.route_m
               : f.route_m - params.gain_m_per_m * f.width_m;
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < frontiers.size(); ++i)
    if (frontiers[i].left.empty() && (!best || cost(frontiers[i]) < cost(frontiers[*best])))
      best = i;
  return best;
}

}  // namespace ariadne::explore
