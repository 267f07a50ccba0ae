// The goal to see what is unknown: the next frontier, kept while it is there.
#pragma once
#include <vector>

#include "ariadne/explore/frontiers.h"
#include "ariadne/explore/goal.h"

namespace ariadne::explore {

/// As they stand in a decision.
std::vector<Candidate> candidatesOf(const std::vector<Frontier>& frontiers);

/// To unknown ground: the nearest frontier, or the one of most use for its distance
/// (`frontier_choice`;
/// Yamauchi, CIRA 1997).
class FrontierGoal {
 public:
  /// A copy is kept.
  explicit FrontierGoal(const ExploreParams& params) : params_(params) {}

  /// Notes another frontier than the one that the robot drives to.
  Answer answer(const Question& question, Logbook& log);
  /// A frontier that is all about there is not gone to again.
  void fail(const mrpt::math::TPoint2D& at, const std::string& why) {
    failed_.push_back({at, why});
  }
  /// As of the last answer, those that are left for a reason too.
  const std::vector<Frontier>& frontiers() const { return frontiers_; }

 private:
  const Frontier& kept(const Frontier& next, const Heading& heading) const;

  ExploreParams params_;
  std::vector<Frontier> frontiers_;
  std::vector<FailedTarget> failed_;
};

}  // namespace ariadne::explore
