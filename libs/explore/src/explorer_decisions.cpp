// Where to go next: the explorer's decisions, looked over again and again while it drives.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/core/cpu_clock.h"
#include "ariadne/explore/explorer.h"
#include "ariadne/explore/guard.h"
#include "ariadne/explore/strategy.h"
#include "ariadne/models/motion_model.h"

namespace ariadne::explore {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

double distance(const TPoint2D& a, const TPoint2D& b) { return std::hypot(a.x - b.x, a.y - b.y); }

const filter::Particle& bestOf(const slam::Mapper& mapper) {
  return mapper.particles()[mapper.particles().best()];
}

/// What the laser sees now and what was touched count as walls, whatever the map says.
std::vector<TPoint2D> obstaclesNow(const Belief& belief, const std::vector<TPoint2D>& touched_at) {
  constexpr double kNear_m = 3;
  std::vector<TPoint2D> points = touched_at;
  const TPose2D pose = belief.mapper.pose();
  for (const TPoint2D& hit : hitsOf(belief.scan, kNear_m)) {
    const TPose2D at = models::compose(pose, {hit.x, hit.y, 0});
    points.emplace_back(at.x, at.y);
  }
  return points;
}

LoopNumbers numbersOf(const closing::Closing& loop) {
  return {loop.name, loop.opportunity.places, loop.opportunity.dist_m_m, loop.opportunity.dist_g_m,
          loop.opportunity.te};
}

std::vector<Candidate> candidatesOf(const std::vector<Frontier>& frontiers) {
  std::vector<Candidate> out;
  for (const Frontier& f : frontiers)
    out.push_back({f.target, f.width_m,
                   f.stand >= 0 ? std::optional<double>(f.way_m) : std::nullopt, f.left});
  return out;
}

}  // namespace

void Explorer::decide(const Belief& belief) {
  const double start_s = core::threadCpu_s();
  decided_at_s_ = checked_at_s_ = belief.time_s;
  checked_at_m_ = travelled_m_;
  const TPose2D pose = belief.mapper.pose();
  const Planner planner(
      std::make_shared<PlanningGrid>(bestOf(belief.mapper).map, params_.planning_cell_m,
                                     obstaclesNow(belief, touched_at_)),
      {pose.x, pose.y}, params_);
  if (!isActive(params_.strategy) || !decideLoop(belief, planner)) decideFrontier(belief, planner);
  const double took_s = core::threadCpu_s() - start_s;
  slowest_s_ = std::max(slowest_s_, took_s);
  decisions_s_ += took_s;
}

/// Never a second closing within one: the outermost that is being followed comes first.
bool Explorer::decideLoop(const Belief& belief, const Planner& planner) {
  const auto open = belief.mapper.openClosings();
  for (const closing::Closing* loop : open)
    if (loop->entered && !left_.contains(*loop)) return followLoop(belief, planner, *loop);
  if (open.empty() || open.back()->entered || left_.contains(*open.back())) return false;
  return approachEntry(belief, planner, *open.back());
}

bool Explorer::approachEntry(const Belief& belief, const Planner& planner,
                             const closing::Closing& loop) {
  const TPose2D at_te =
      filter::ancestorAt(bestOf(belief.mapper).ancestor, loop.opportunity.te)->pose();
  const TPoint2D entry{at_te.x, at_te.y};
  const int cell = planner.nearestTo(entry, 1);
  if (cell < 0) {
    leave(belief, loop, "no way leads to the entry");
    return false;
  }
  if (goal_ == Goal::entry && follower_.arrived(belief.mapper.pose())) {
    leave(belief, loop, "at the entry's place the robot does not recognise it");
    return false;
  }
  loop_name_ = loop.name;
  if (goal_ != Goal::entry) {
    Decision& d = note(belief, DecisionKind::approach,
                       fmt::format("a loop can be closed: {:.1f} m by the map, {:.1f} m by the "
                                   "graph; drives to its entry",
                                   loop.opportunity.dist_m_m, loop.opportunity.dist_g_m));
    d.goal = entry;
    d.loop = numbersOf(loop);
  }
  go(Goal::entry, entry, planner.routeTo(cell));
  return true;
}

bool Explorer::followLoop(const Belief& belief, const Planner& planner,
                          const closing::Closing& loop) {
  loop_name_ = loop.name;
  if (!loop_route_ || followed_ != loop.name) {
    loop_route_.emplace(loop.opportunity.te, *loop.entered);
    followed_ = loop.name;
    note(belief, DecisionKind::follow,
         "at the entry of the loop: follows the path taken from there")
        .loop = numbersOf(loop);
  }
  if (loop_route_->laps() >= params_.max_laps) {
    leave(belief, loop, fmt::format("followed for {} laps (max_laps)", params_.max_laps));
    return false;
  }
  // It may have come as near to the last place as it can and still not have passed it.
  if (goal_ == Goal::loop && follower_.arrived(belief.mapper.pose())) loop_route_->skip();
  for (int attempt = 0; attempt < params_.giveup; ++attempt) {
    const TPoint2D place = loop_route_->next(bestOf(belief.mapper).ancestor, belief.mapper.pose());
    const int cell = planner.nearestTo(place, 1);
    if (cell >= 0) {
      go(Goal::loop, place, planner.routeTo(cell));
      return true;
    }
    loop_route_->skip();
  }
  leave(belief, loop, "the path through the loop is blocked");
  return false;
}

void Explorer::decideFrontier(const Belief& belief, const Planner& planner) {
  frontiers_ = findFrontiers(planner, params_, failed_);
  const auto next = chooseFrontier(frontiers_, params_);
  if (!next) {
    decideHome(belief, planner);
    return;
  }
  // The one that the robot is on its way to is kept while it is there: no dithering.
  constexpr double kSame_m = 1;
  const Frontier* goal = &frontiers_[*next];
  if (goal_ == Goal::frontier) {
    for (const Frontier& f : frontiers_)
      if (f.left.empty() && std::any_of(f.cells.begin(), f.cells.end(), [&](const TPoint2D& c) {
            return distance(c, target_) < kSame_m;
          })) {
        goal = &f;
        break;
      }
  }
  const bool same = goal_ == Goal::frontier && distance(goal->target, target_) < 2 * kSame_m;
  if (!same) {
    Decision& d = note(belief, DecisionKind::frontier,
                       fmt::format("drives to a frontier {:.1f} m wide, {:.1f} m away",
                                   goal->width_m, goal->way_m));
    d.goal = goal->target;
    d.frontiers = candidatesOf(frontiers_);
  }
  go(Goal::frontier, goal->target, planner.routeTo(goal->stand));
}

void Explorer::decideHome(const Belief& belief, const Planner& planner) {
  if (params_.drive_home) {
    const TPose2D start = filter::ancestorAt(bestOf(belief.mapper).ancestor, 0)->pose();
    const int cell = planner.nearestTo({start.x, start.y}, 0.5);
    if (cell >= 0) {
      if (goal_ != Goal::home)
        note(belief, DecisionKind::home, "nothing left to explore: drives home").frontiers =
            candidatesOf(frontiers_);
      go(Goal::home, {start.x, start.y}, planner.routeTo(cell));
      return;
    }
  }
  end(belief, frontiers_.empty() ? "explored: no frontier is left"
                                 : "explored: every frontier that is left has a reason");
  decisions_.back().frontiers = candidatesOf(frontiers_);
}

void Explorer::leave(const Belief& belief, const closing::Closing& loop, const std::string& why) {
  Decision& d = note(belief, DecisionKind::give_up, "leaves the loop: " + why);
  d.loop = numbersOf(loop);
  left_.add(loop, bestOf(belief.mapper).map);
  goal_ = Goal::none;
}

}  // namespace ariadne::explore
