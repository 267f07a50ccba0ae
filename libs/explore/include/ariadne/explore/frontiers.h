// Frontiers (Yamauchi, 1997): where what is known to be free borders on the unknown.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ariadne/explore/planner.h"

namespace ariadne::explore {

/// Frontier cells that hang together.
struct Frontier {
  std::vector<mrpt::math::TPoint2D> cells;  ///< centres, m, map frame
  double width_m = 0;                       ///< diagonal of the box of its cells' centres
  mrpt::math::TPoint2D
      target;          ///< the cell to look at; of the cells the one with the shortest route
  int stand = -1;      ///< where the robot stands to see it; -1: none
  double route_m = 0;  ///< to `stand`
  std::string left;    ///< why it is not gone to; empty: it may be
};

/// Places where a frontier was gone to and did not give way.
struct FailedTarget {
  mrpt::math::TPoint2D at;
  std::string why;
};

/// All frontiers, those with a reason to be left too, in the order of their first cell. Cells
/// within the robot's radius of a wall do not count: its centre cannot pass there. A frontier is
/// left when it is narrower than the robot, when no route leads to a place from which it can be
/// seen, or when all of it is near failed targets.
std::vector<Frontier> findFrontiers(const Planner& planner, const ExploreParams& params,
                                    const std::vector<FailedTarget>& failed);

/// Index of the frontier to go to next, see FrontierChoice; nothing when all are left.
std::optional<std::size_t> chooseFrontier(const std::vector<Frontier>& frontiers,
                                          const ExploreParams& params);

}  // namespace ariadne::explore
