#include "ariadne/explore/frontier_goal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

using mrpt::math::TPoint2D;

constexpr double kSame_m = 1;

}  // namespace

std::vector<Candidate> candidatesOf(const std::vector<Frontier>& frontiers) {
  std::vector<Candidate> out;
  for (const Frontier& f : frontiers)
    out.push_back({f.target, f.width_m,
                   f.stand >= 0 ? std::optional<double>(f.route_m) : std::nullopt, f.left});
  return out;
}

/// The one that the robot drives to is kept while it is there: no dithering.
const Frontier& FrontierGoal::kept(const Frontier& next, const Heading& heading) const {
  if (heading.purpose != Purpose::frontier) return next;
  for (const Frontier& f : frontiers_)
    if (f.left.empty() && std::any_of(f.cells.begin(), f.cells.end(), [&](const TPoint2D& c) {
          return geometry::distance(c, heading.at) < kSame_m;
        }))
      return f;
  return next;
}

Answer FrontierGoal::answer(const Question& q, Logbook& log) {
  frontiers_ = findFrontiers(q.planner, params_, failed_);
  const auto next = chooseFrontier(frontiers_, params_);
  if (!next)
    return {{},
            frontiers_.empty() ? "explored: no frontier is left"
                               : "explored: every frontier that is left has a reason"};
  const Frontier& goal = kept(frontiers_[*next], q.heading);
  const bool same = q.heading.purpose == Purpose::frontier &&
                    geometry::distance(goal.target, q.heading.at) < 2 * kSame_m;
  if (!same) {
    Decision& d = log.note(q.belief, DecisionKind::frontier,
                           fmt::format("drives to a frontier {:.1f} m wide, {:.1f} m away",
                                       goal.width_m, goal.route_m));
    d.goal = goal.target;
    d.frontiers = candidatesOf(frontiers_);
  }
  return {Destination{{Purpose::frontier, goal.target}, q.planner.routeTo(goal.stand)}, ""};
}

}  // namespace ariadne::explore
