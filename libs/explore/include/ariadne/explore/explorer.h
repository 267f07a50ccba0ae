// The robot that decides for itself where to go (section IV): to frontiers, and, where an active
// strategy is set, back to the entry of a loop and through it before that. It knows what the
// filter believes and what its sensors say, and nothing else: this library does not link the
// simulator. Where to go is the goals' word (loop_goal.h, frontier_goal.h, home_goal.h); here is
// when they are asked, and what the robot does in between.
#pragma once
#include "ariadne/explore/believed_motion.h"
#include "ariadne/explore/bumper.h"
#include "ariadne/explore/frontier_goal.h"
#include "ariadne/explore/home_goal.h"
#include "ariadne/explore/loop_goal.h"
#include "ariadne/explore/route_follower.h"

namespace ariadne::explore {

/// Decides by belief alone where the robot drives next, and drives it there: to a loop, a frontier,
/// home.
class Explorer {
 public:
  /// Throws core::UsageError when a parameter is out of bounds.
  explicit Explorer(const ExploreParams& params);

  /// What to do until the next scan; stands still when it is done.
  models::VelocityCommand step(const Belief& belief);

  /// Whether the exploration has ended, for whatever reason.
  bool done() const { return mode_ == Mode::done; }
  /// Why it ended; empty before.
  const std::string& endReason() const { return end_reason_; }
  /// All decisions, in order.
  const std::vector<Decision>& decisions() const { return log_.decisions(); }
  /// What it is doing, in words.
  std::string doing() const;
  /// What is being followed; empty when nothing is.
  const Route& route() const { return follower_.route(); }
  /// All frontiers as of the last decision.
  const std::vector<Frontier>& frontiers() const { return frontier_goal_.frontiers(); }
  /// Way that the filter believes to have driven, m.
  double travelled_m() const { return motion_.travelled_m(); }
  /// CPU time of the slowest decision, s.
  double slowestDecision_s() const { return slowest_s_; }
  /// CPU time of all decisions, s.
  double decisions_s() const { return decisions_s_; }

 private:
  enum class Mode { looking_around, driving, facing, backing_off, done };

  void decide(const Belief& belief);
  Answer ask(const Question& question);
  bool mustDecide(const Belief& belief);
  bool routeStands(const Belief& belief) const;
  models::VelocityCommand act(const Belief& belief);
  models::VelocityCommand lookAround(const Belief& belief);
  models::VelocityCommand drive(const Belief& belief);
  models::VelocityCommand arrive(const Belief& belief);
  void blocked(const Belief& belief);
  models::VelocityCommand face(const Belief& belief);
  models::VelocityCommand backOff(const Belief& belief);
  void touch(const Belief& belief);
  void giveUp(const Belief& belief, const std::string& why);
  void go(Destination where);
  models::VelocityCommand end(const Belief& belief, const std::string& reason);

  ExploreParams params_;
  FrontierGoal frontier_goal_;
  LoopGoal loop_goal_;
  HomeGoal home_goal_;
  RouteFollower follower_;
  Bumper bumper_;
  BelievedMotion motion_;
  Logbook log_;
  Mode mode_ = Mode::looking_around;
  Heading heading_;
  std::string end_reason_;
  std::optional<double> started_s_;  // time of the first scan
  double mode_since_s_ = 0;
  double decided_at_s_ = 0;
  double checked_at_m_ = 0;
  double checked_at_s_ = 0;
  std::size_t updates_ = 0;  // of the filter, at the last step
  int lost_ = 0;             // how often in a row the route to the goal was lost
  double slowest_s_ = 0;
  double decisions_s_ = 0;
};

}  // namespace ariadne::explore
