// The robot that decides for itself where to go (section IV): to frontiers, and, where an active
// strategy is set, back to the entry of a loop and through it before that. It knows what the
// filter believes and what its sensors say, and nothing else: this library does not link the
// simulator.
#pragma once
#include <functional>

#include "ariadne/explore/decision.h"
#include "ariadne/explore/frontiers.h"
#include "ariadne/explore/left_loops.h"
#include "ariadne/explore/loop_route.h"
#include "ariadne/explore/route_follower.h"
#include "ariadne/slam/mapper.h"

namespace ariadne::explore {

/// What the robot knows after a scan.
struct Belief {
  double time_s = 0;                               ///< of the scan, from any moment on
  const slam::Mapper& mapper;                      ///< has processed the scan
  const mrpt::obs::CObservation2DRangeScan& scan;  ///< the latest
  bool touched = false;                            ///< the bumper's word since the last scan
};

class Explorer {
 public:
  /// Throws core::UsageError when a parameter is out of bounds.
  explicit Explorer(const ExploreParams& params);

  /// What to do until the next scan; stands still when it is done.
  models::VelocityCommand step(const Belief& belief);

  bool done() const { return mode_ == Mode::done; }
  /// Why it ended; empty before.
  const std::string& endReason() const { return end_reason_; }
  const std::vector<Decision>& decisions() const { return decisions_; }
  /// What it is doing, in words.
  std::string doing() const;
  const Route& route() const { return follower_.route(); }
  /// All frontiers as of the last decision.
  const std::vector<Frontier>& frontiers() const { return frontiers_; }
  /// Way that the filter believes to have driven, m.
  double travelled_m() const { return travelled_m_; }
  /// CPU time of the slowest decision, s.
  double slowestDecision_s() const { return slowest_s_; }
  /// CPU time of all decisions, s.
  double decisions_s() const { return decisions_s_; }

 private:
  enum class Mode { looking_around, driving, facing, backing_off, done };
  enum class Goal { none, frontier, entry, loop, home };

  void decide(const Belief& belief);
  bool decideLoop(const Belief& belief, const Planner& planner);
  bool approachEntry(const Belief& belief, const Planner& planner, const closing::Closing& loop);
  bool followLoop(const Belief& belief, const Planner& planner, const closing::Closing& loop);
  void decideFrontier(const Belief& belief, const Planner& planner);
  void decideHome(const Belief& belief, const Planner& planner);
  models::VelocityCommand act(const Belief& belief);
  models::VelocityCommand drive(const Belief& belief);
  models::VelocityCommand face(const Belief& belief);
  models::VelocityCommand lookAround(const Belief& belief);
  models::VelocityCommand backOff(const Belief& belief);
  void touch(const Belief& belief);
  void giveUp(const Belief& belief, const std::string& why);
  void failTarget(const std::string& why);
  void leave(const Belief& belief, const closing::Closing& loop, const std::string& why);
  models::VelocityCommand end(const Belief& belief, const std::string& reason);
  void go(Goal goal, const mrpt::math::TPoint2D& target, Route route);
  Decision& note(const Belief& belief, DecisionKind kind, const std::string& text);
  bool reconsiders(const Belief& belief);
  bool goalStands(const Belief& belief) const;

  ExploreParams params_;
  RouteFollower follower_;
  Mode mode_ = Mode::looking_around;
  Goal goal_ = Goal::none;
  mrpt::math::TPoint2D target_;  // of the goal, map frame
  std::string end_reason_;
  std::vector<Decision> decisions_;
  std::vector<Frontier> frontiers_;
  std::vector<FailedTarget> failed_;
  std::vector<mrpt::math::TPoint2D> touched_at_;  // map frame
  LeftLoops left_;
  std::optional<LoopRoute> loop_route_;
  std::size_t followed_ = 0;                   // the closing that loop_route_ is of
  std::size_t loop_name_ = 0;                  // that the robot drives to or follows
  std::optional<mrpt::math::TPose2D> before_;  // pose at the last step
  std::optional<double> started_s_;            // time of the first scan
  double travelled_m_ = 0;
  double turned_ = 0;  // rad, in the present look around
  double mode_since_s_ = 0;
  double decided_at_s_ = 0;
  double checked_at_m_ = 0;
  double checked_at_s_ = 0;
  std::size_t updates_ = 0;  // of the filter, at the last step
  int lost_ = 0;             // how often in a row the way to the goal was lost
  int touches_ = 0;
  double slowest_s_ = 0;
  double decisions_s_ = 0;
};

}  // namespace ariadne::explore
