// Shortest routes for the robot's disc through what is known to be free, from where it stands to
// everywhere: one search a decision.
#pragma once
#include <memory>
#include <vector>

#include "ariadne/explore/params.h"
#include "ariadne/explore/planning_grid.h"

namespace ariadne::explore {

using Route = std::vector<mrpt::math::TPoint2D>;  ///< m, map frame

/// The cheapest routes from the robot to every cell that it can reach: a bucket search over all
/// cells at once.
class Planner {
 public:
  /// Routes keep the robot's radius and clearance from walls and its radius from the unknown, and
  /// cost up to three times their length where walls are nearer than preferred. A robot that
  /// already stands too near may leave the place.
  Planner(std::shared_ptr<const PlanningGrid> grid, const mrpt::math::TPoint2D& robot,
          const ExploreParams& params);

  /// The cells that it plans on.
  const PlanningGrid& grid() const { return *grid_; }
  /// Whether the robot may stand there.
  bool open(int cell) const { return open_[cell] != 0; }
  /// Whether a route leads there.
  bool reaches(int cell) const { return cost_[cell] >= 0; }
  /// What the search minimises; needs reaches().
  int cost(int cell) const { return cost_[cell]; }
  /// Length of the route, m; needs reaches().
  double length(int cell) const;
  /// The route from the robot to the cell; needs reaches().
  Route routeTo(int cell) const;
  /// The reachable cell nearest to a point by cost, among those within `radius_m` of it and in
  /// sight of it; -1 when there is none.
  int nearestTo(const mrpt::math::TPoint2D& point, double radius_m) const;

 private:
  void markOpen(const ExploreParams& params, int start);
  void search(int start);
  int penalised(int step, int cell) const;

  std::shared_ptr<const PlanningGrid> grid_;
  double preferred_m_;
  std::vector<std::uint8_t> open_;
  std::vector<int> cost_;    // -1 not reached
  std::vector<int> before_;  // cell that the route comes from
};

}  // namespace ariadne::explore
