// When the explorer decides anew, and whom it asks: the loop first, then frontiers, then home.
#include <algorithm>
#include <cmath>

#include "ariadne/core/cpu_clock.h"
#include "ariadne/explore/explorer.h"
#include "ariadne/explore/goal_check.h"
#include "ariadne/explore/guard.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// What the laser sees now and what was touched count as walls, whatever the map says.
std::vector<TPoint2D> obstaclesNow(const Belief& belief, const Bumper& bumper) {
  constexpr double kNear_m = 3;
  std::vector<TPoint2D> points = bumper.points();
  for (const TPoint2D& hit : hitsOf(belief.scan, kNear_m)) {
    const TPose2D at = geometry::compose(belief.map_from_robot, {hit.x, hit.y, 0});
    points.emplace_back(at.x, at.y);
  }
  return points;
}

}  // namespace

void Explorer::decide(const Belief& belief) {
  const double start_s = core::threadCpu_s();
  decided_at_s_ = checked_at_s_ = belief.time_s;
  checked_at_m_ = travelled_m();
  const TPose2D& pose = belief.map_from_robot;
  const Planner planner(std::make_shared<PlanningGrid>(belief.map, params_.planning_cell_m,
                                                       obstaclesNow(belief, bumper_)),
                        {pose.x, pose.y}, params_);
  const Answer answer = ask({belief, planner, heading_, follower_.arrived(pose)});
  if (answer.where) {
    go(*answer.where);
  } else {
    end(belief, answer.why_not);
    log_.last().frontiers = candidatesOf(frontiers());
  }
  const double took_s = core::threadCpu_s() - start_s;
  slowest_s_ = std::max(slowest_s_, took_s);
  decisions_s_ += took_s;
}

Answer Explorer::ask(const Question& question) {
  if (Answer loop = loop_goal_.answer(question, log_); loop.where) return loop;
  Answer frontier = frontier_goal_.answer(question, log_);
  if (frontier.where) return frontier;
  if (Answer home = home_goal_.answer(question, candidatesOf(frontiers()), log_); home.where)
    return home;
  return frontier;
}

/// A decision is made anew when a loop opens or closes, and when what it aimed at is gone.
bool Explorer::mustDecide(const Belief& belief) {
  const bool to_entry = heading_.purpose == Purpose::entry;
  const bool in_loop = heading_.purpose == Purpose::loop;
  if (loop_goal_.isThere(belief) != (to_entry || in_loop)) return true;
  if (to_entry && belief.open.back()->entered) return true;
  // So that it never has to brake.
  constexpr double kNearPlace_m = 1.5;
  const double since_check_m = travelled_m() - checked_at_m_;
  const double left_m = geometry::distance(heading_.at, belief.map_from_robot);
  if (in_loop && left_m < kNearPlace_m && since_check_m > 0.3) return true;
  if (belief.time_s - checked_at_s_ >= 5) return true;  // hardly moves
  if (since_check_m < 1) return false;
  checked_at_m_ = travelled_m();
  checked_at_s_ = belief.time_s;
  return !routeStands(belief);
}

bool Explorer::routeStands(const Belief& belief) const {
  if (heading_.purpose == Purpose::frontier &&
      !bordersUnknown(belief.map, heading_.at, 1.5 * params_.planning_cell_m))
    return false;
  return routeHolds(belief.map, follower_.route(), follower_.next(), belief.map_from_robot,
                    params_);
}

/// What the robot drives to already is not gone to again.
void Explorer::giveUp(const Belief& belief, const std::string& why) {
  switch (heading_.purpose) {
    case Purpose::entry:
    case Purpose::loop:
      if (loop_goal_.giveUp(belief, why, log_)) heading_.purpose = Purpose::none;
      break;
    case Purpose::home:
      end(belief, "explored; " + why);
      break;
    case Purpose::frontier:
    case Purpose::none:
      frontier_goal_.fail(heading_.at, why);
  }
  lost_ = 0;
}

void Explorer::go(Destination where) {
  const bool same = where.heading.purpose == heading_.purpose &&
                    geometry::distance(where.heading.at, heading_.at) < 0.5;
  if (!same) lost_ = 0;
  heading_ = where.heading;
  follower_.take(std::move(where.route));
  mode_ = Mode::driving;
}

}  // namespace ariadne::explore
