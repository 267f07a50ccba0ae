#include "ariadne/explore/loop_goal.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/explore/strategy.h"

namespace ariadne::explore {
namespace {

using loops::Closing;
using mrpt::math::TPoint2D;

LoopNumbers numbersOf(const Closing& loop) {
  return {loop.id, loop.opportunity.places.size(), loop.opportunity.dist_m_m,
          loop.opportunity.dist_g_m, loop.opportunity.te};
}

}  // namespace

bool LoopGoal::isThere(const Belief& belief) const {
  return isActive(params_.strategy) &&
         std::any_of(belief.open.begin(), belief.open.end(),
                     [&](const Closing* loop) { return !left_.contains(*loop); });
}

/// The outermost that is being followed comes first.
Answer LoopGoal::answer(const Question& q, Logbook& log) {
  if (!isActive(params_.strategy)) return {{}, "the strategy closes no loop on purpose"};
  const auto& open = q.belief.open;
  for (const Closing* loop : open)
    if (loop->entered && !left_.contains(*loop)) return through(q, *loop, log);
  if (open.empty() || open.back()->entered || left_.contains(*open.back()))
    return {{}, "no loop is open that was not given up"};
  return toEntry(q, *open.back(), log);
}

Answer LoopGoal::toEntry(const Question& q, const Closing& loop, Logbook& log) {
  constexpr double kAbout_m = 1;
  const auto at_te = filter::ancestorAt(q.belief.path, loop.opportunity.te)->pose();
  const TPoint2D entry{at_te.x, at_te.y};
  const int cell = q.planner.nearestTo(entry, kAbout_m);
  if (cell < 0) return leave(q.belief, loop, "no route leads to the entry", log);
  const bool on_its_way = q.heading.purpose == Purpose::entry;
  if (on_its_way && q.arrived)
    return leave(q.belief, loop, "at the entry's place the robot does not recognise it", log);
  aimed_at_ = loop.id;
  if (!on_its_way) {
    Decision& d = log.note(q.belief, DecisionKind::approach,
                           fmt::format("a loop can be closed: {:.1f} m by the map, {:.1f} m by the "
                                       "graph; drives to its entry",
                                       loop.opportunity.dist_m_m, loop.opportunity.dist_g_m));
    d.goal = entry;
    d.loop = numbersOf(loop);
  }
  return {Destination{{Purpose::entry, entry}, q.planner.routeTo(cell)}, ""};
}

Answer LoopGoal::through(const Question& q, const Closing& loop, Logbook& log) {
  constexpr double kAbout_m = 1;
  aimed_at_ = loop.id;
  if (!route_ || followed_ != loop.id) {
    route_.emplace(loop.opportunity.te, *loop.entered);
    followed_ = loop.id;
    log.note(q.belief, DecisionKind::follow,
             "at the entry of the loop: follows the path taken from there")
        .loop = numbersOf(loop);
  }
  if (route_->laps() >= params_.max_laps)
    return leave(q.belief, loop, fmt::format("followed for {} laps (max_laps)", params_.max_laps),
                 log);
  // It may have come as near to the last place as it can and still not have passed it.
  if (q.heading.purpose == Purpose::loop && q.arrived) route_->skip();
  for (int attempt = 0; attempt < params_.giveup; ++attempt) {
    const TPoint2D place = route_->next(q.belief.path, q.belief.map_from_robot);
    const int cell = q.planner.nearestTo(place, kAbout_m);
    if (cell >= 0) return {Destination{{Purpose::loop, place}, q.planner.routeTo(cell)}, ""};
    route_->skip();
  }
  return leave(q.belief, loop, "the path through the loop is blocked", log);
}

Answer LoopGoal::leave(const Belief& belief, const Closing& loop, const std::string& why,
                       Logbook& log) {
  const std::string text = "leaves the loop: " + why;
  log.note(belief, DecisionKind::give_up, text).loop = numbersOf(loop);
  left_.add(loop, belief.map);
  return {{}, text};
}

bool LoopGoal::giveUp(const Belief& belief, const std::string& why, Logbook& log) {
  for (const Closing* loop : belief.open)
    if (loop->id == aimed_at_) {
      leave(belief, *loop, why, log);
      return true;
    }
  return false;
}

}  // namespace ariadne::explore
