// What the explorer decided, with the numbers it decided on: for events.json and the report.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <string>
#include <vector>

namespace ariadne::explore {

/// A frontier that there was at a decision.
struct Candidate {
  mrpt::math::TPoint2D at;  ///< m, map frame
  double width_m = 0;
  std::optional<double> route_m;  ///< nothing where no route leads there
  std::string left;               ///< why it is not gone to; empty: it may be
};

/// The loop that a decision is about, Eq. (7) and (9).
struct LoopNumbers {
  std::size_t closing = 0;  ///< its name in loops.json
  std::size_t places = 0;   ///< |I(s)|
  double dist_m = 0;        ///< m
  double dist_g = 0;        ///< m
  std::size_t te = 0;       ///< filter update
};

/// What a decision is about.
enum class DecisionKind { frontier, approach, follow, give_up, touched, home, end };

/// One decision of the explorer: what it chose, from what, and why.
struct Decision {
  DecisionKind kind = DecisionKind::end;
  double time_s = 0;
  std::size_t update = 0;              ///< of the filter
  mrpt::math::TPose2D map_from_robot;  ///< as believed
  std::string text;                    ///< what and why, in words
  std::optional<mrpt::math::TPoint2D> goal;
  std::vector<Candidate> frontiers;  ///< all there were; empty where none were looked for
  std::optional<LoopNumbers> loop;
};

/// As events.json has it.
const char* nameOf(DecisionKind kind);

}  // namespace ariadne::explore
