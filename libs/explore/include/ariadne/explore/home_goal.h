// The goal to come back to the start when nothing is left to explore.
#pragma once
#include "ariadne/explore/goal.h"

namespace ariadne::explore {

/// Back to where the drive began, once nothing else is left.
class HomeGoal {
 public:
  /// Only where `drive_home` is set.
  explicit HomeGoal(const ExploreParams& params) : wanted_(params.drive_home) {}

  /// Notes that the robot sets out. @param left frontiers that are not gone to, for that note
  Answer answer(const Question& question, const std::vector<Candidate>& left, Logbook& log) const;

 private:
  bool wanted_;
};

}  // namespace ariadne::explore
