#include "ariadne/explore/logbook.h"

namespace ariadne::explore {

Decision& Logbook::note(const Belief& belief, DecisionKind kind, const std::string& text) {
  Decision d;
  d.kind = kind;
  d.time_s = belief.time_s;
  d.update = belief.updates - 1;
  d.map_from_robot = belief.map_from_robot;
  d.text = text;
  decisions_.push_back(std::move(d));
  return decisions_.back();
}

}  // namespace ariadne::explore
