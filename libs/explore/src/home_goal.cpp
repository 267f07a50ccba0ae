#include "ariadne/explore/home_goal.h"

namespace ariadne::explore {

Answer HomeGoal::answer(const Question& q, const std::vector<Candidate>& left, Logbook& log) const {
  constexpr double kAbout_m = 0.5;
  if (!wanted_) return {{}, "drive_home is false"};
  const mrpt::math::TPose2D start = filter::ancestorAt(q.belief.path, 0)->pose();
  const mrpt::math::TPoint2D at{start.x, start.y};
  const int cell = q.planner.nearestTo(at, kAbout_m);
  if (cell < 0) return {{}, "no route leads home"};
  if (q.heading.purpose != Purpose::home)
    log.note(q.belief, DecisionKind::home, "nothing left to explore: drives home").frontiers = left;
  return {Destination{{Purpose::home, at}, q.planner.routeTo(cell)}, ""};
}

}  // namespace ariadne::explore
