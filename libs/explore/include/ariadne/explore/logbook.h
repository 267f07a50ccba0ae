// Every decision as it was made.
#pragma once
#include <string>
#include <vector>

#include "ariadne/explore/belief.h"
#include "ariadne/explore/decision.h"

namespace ariadne::explore {

/// The decisions in order, with the belief that each was made by.
class Logbook {
 public:
  /// The entry may be filled on until the next one.
  Decision& note(const Belief& belief, DecisionKind kind, const std::string& text);
  /// In order.
  const std::vector<Decision>& decisions() const { return decisions_; }
  /// The newest; there must be one.
  Decision& last() { return decisions_.back(); }

 private:
  std::vector<Decision> decisions_;
};

}  // namespace ariadne::explore
