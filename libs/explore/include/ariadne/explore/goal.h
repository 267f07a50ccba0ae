// What a goal is asked, and what it answers: where to, or why not.
#pragma once
#include <optional>
#include <string>

#include "ariadne/explore/logbook.h"
#include "ariadne/explore/planner.h"

namespace ariadne::explore {

/// What the robot drives for.
enum class Purpose { none, frontier, entry, loop, home };

/// What the robot drives to.
struct Heading {
  Purpose purpose = Purpose::none;
  mrpt::math::TPoint2D at;  ///< m, map frame
};

/// The moment of a decision.
struct Question {
  const Belief& belief;
  const Planner& planner;  ///< of this moment's map
  Heading heading;         ///< as decided before
  bool arrived = false;    ///< the robot is where that leads
};

/// Where to drive, by which heading and route.
struct Destination {
  Heading heading;
  Route route;  ///< from the robot to there
};

/// What a goal says when it is asked: where to, or why not.
struct Answer {
  std::optional<Destination> where;
  std::string why_not;  ///< empty when there is one
};

}  // namespace ariadne::explore
