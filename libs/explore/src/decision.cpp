#include "ariadne/explore/decision.h"

namespace ariadne::explore {

const char* nameOf(DecisionKind kind) {
  switch (kind) {
    case DecisionKind::frontier:
      return "frontier";
    case DecisionKind::approach:
      return "approach";
    case DecisionKind::follow:
      return "follow";
    case DecisionKind::give_up:
      return "give_up";
    case DecisionKind::touched:
      return "touched";
    case DecisionKind::home:
      return "home";
    case DecisionKind::end:
      return "end";
  }
  return "";
}

}  // namespace ariadne::explore
