// Every decision as it was made.
#pragma once
#include <string>
#include <vector>

#include "ariadne/explore/belief.h"
#include "ariadne/explore/decision.h"

namespace ariadne::explore {

class Logbook {
 public:
  /// The entry may be filled on until the next one.
  Decision& note(const Belief& belief, DecisionKind kind, const std::string& text);
  const std::vector<Decision>& decisions() const { return decisions_; }
  Decision& last() { return decisions_.back(); }

 private:
  std::vector<Decision> decisions_;
};

}  // namespace ariadne::explore
