// Follows a route with a robot that has a differential drive and believes to be somewhere: it aims
// at a point a little ahead on the route (pure pursuit; Coulter, CMU-RI-TR-92-01, 1992), and turns
// on the spot where that lies far to its side. It does not cut a corner that its laser sees.
#pragma once
#include "ariadne/explore/planner.h"
#include "ariadne/models/velocity_command.h"

namespace ariadne::explore {

/// Turns a route into velocities, by what is in the way now.
class RouteFollower {
 public:
  /// A copy is kept.
  explicit RouteFollower(const ExploreParams& params) : params_(params) {}

  /// A new route; an empty one has nowhere to go.
  void take(Route route);
  /// What is left of it lies ahead of the robot.
  const Route& route() const { return route_; }
  /// First point of the route that is not behind the robot.
  std::size_t next() const { return next_; }
  /// Whether the robot is within a hand's breadth of the end.
  bool arrived(const mrpt::math::TPose2D& map_from_robot) const;
  /// What to do now; stands still without a route and at its end.
  /// @param hits what the laser sees near by, m, robot's frame
  models::VelocityCommand command(const mrpt::math::TPose2D& map_from_robot,
                                  const std::vector<mrpt::math::TPoint2D>& hits);
  /// Turns on the spot towards a point; stands still when it is ahead.
  models::VelocityCommand face(const mrpt::math::TPose2D& map_from_robot,
                               const mrpt::math::TPoint2D& point);

 private:
  mrpt::math::TPoint2D aim(const mrpt::math::TPose2D& robot,
                           const std::vector<mrpt::math::TPoint2D>& hits);

  ExploreParams params_;
  Route route_;
  std::size_t next_ = 0;
  bool turning_ = false;  // on the spot
};

}  // namespace ariadne::explore
