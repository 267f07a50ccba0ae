// The goal to close a loop (section IV): to its entry, then along the path that was taken from
// there. Never a second closing within one.
#pragma once
#include "ariadne/explore/goal.h"
#include "ariadne/explore/left_loops.h"
#include "ariadne/explore/loop_route.h"

namespace ariadne::explore {

/// Through an open loop on purpose: the paper's active closing.
class LoopGoal {
 public:
  /// A copy is kept.
  explicit LoopGoal(const ExploreParams& params) : params_(params) {}

  /// Notes a loop that is new, and one that it gives up.
  Answer answer(const Question& question, Logbook& log);
  /// Whether a loop is open that was not given up.
  bool isThere(const Belief& belief) const;
  /// Gives up the loop of the last answer; false when that is open no more.
  bool giveUp(const Belief& belief, const std::string& why, Logbook& log);
  /// To be called after each update: entries where the map has changed may be gone to again.
  void look(const grid::OccupancyGrid& map) { left_.forgetWhereChanged(map); }

 private:
  Answer toEntry(const Question& question, const loops::Closing& loop, Logbook& log);
  Answer through(const Question& question, const loops::Closing& loop, Logbook& log);
  Answer leave(const Belief& belief, const loops::Closing& loop, const std::string& why,
               Logbook& log);

  ExploreParams params_;
  LeftLoops left_;
  std::optional<LoopRoute> route_;
  std::size_t followed_ = 0;  // the closing that route_ is of
  std::size_t aimed_at_ = 0;  // the closing of the last answer
};

}  // namespace ariadne::explore
