#include "ariadne/explore/route_follower.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

using models::VelocityCommand;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kDegree = M_PI / 180;
constexpr double kArrived_m = 0.15;
constexpr double kLookahead_m = 0.5;
constexpr double kLeastLookahead_m = 0.25;
constexpr double kBeside_m = 0.06;  // planned routes keep clearance_m (0.08)
// Turning on the spot begins and ends at different errors, or the robot would dither.
constexpr double kBeginTurn = 40 * kDegree;
constexpr double kEndTurn = 10 * kDegree;
constexpr double kTurnGain = 1.5;   // rad/s per rad: stable at five commands a second
constexpr double kBrakeGain = 1.5;  // m/s per m before the end
constexpr double kSlowest_m_s = 0.1;

double errorTo(const TPoint2D& p, const TPose2D& robot) {
  return std::remainder(std::atan2(p.y - robot.y, p.x - robot.x) - robot.phi, 2 * M_PI);
}

/// Whether the robot's disc passes straight to a point, beside what the laser sees.
bool passes(const TPose2D& robot, const TPoint2D& point, const std::vector<TPoint2D>& hits,
            double radius_m) {
  const TPose2D to = geometry::relativePose(robot, {point.x, point.y, 0});
  const double length = std::hypot(to.x, to.y);
  if (length == 0) return true;
  return std::none_of(hits.begin(), hits.end(), [&](const TPoint2D& p) {
    const double along = std::clamp((p.x * to.x + p.y * to.y) / length, 0.0, length);
    return std::hypot(p.x - along * to.x / length, p.y - along * to.y / length) < radius_m;
  });
}

}  // namespace

void RouteFollower::take(Route route) {
  route_ = std::move(route);
  next_ = 0;
  turning_ = false;
}

bool RouteFollower::arrived(const TPose2D& robot) const {
  return route_.empty() || geometry::distance(route_.back(), robot) <= kArrived_m;
}

/// The nearest point of what lies ahead, then on to the lookahead, as far as no corner is cut.
TPoint2D RouteFollower::aim(const TPose2D& robot, const std::vector<TPoint2D>& hits) {
  constexpr std::size_t kWindow = 20;  // points: the route may pass this place again later
  const auto from = route_.begin() + static_cast<std::ptrdiff_t>(next_);
  const auto to =
      route_.begin() + static_cast<std::ptrdiff_t>(std::min(route_.size(), next_ + kWindow));
  const auto nearest = std::min_element(from, to, [&](const TPoint2D& a, const TPoint2D& b) {
    return geometry::distance(a, robot) < geometry::distance(b, robot);
  });
  next_ = static_cast<std::size_t>(nearest - route_.begin());
  std::size_t ahead = next_;
  const double wide_m = params_.robot_radius_m + kBeside_m;
  while (ahead + 1 < route_.size() && geometry::distance(route_[ahead], robot) < kLookahead_m &&
         (geometry::distance(route_[ahead], robot) < kLeastLookahead_m ||
          passes(robot, route_[ahead + 1], hits, wide_m)))
    ++ahead;
  return route_[ahead];
}

VelocityCommand RouteFollower::face(const TPose2D& robot, const TPoint2D& point) {
  const double fastest = params_.turn_deg_s * kDegree;
  const double error = errorTo(point, robot);
  if (std::abs(error) < kEndTurn) return {};
  return {0, std::clamp(kTurnGain * error, -fastest, fastest)};
}

VelocityCommand RouteFollower::command(const TPose2D& robot, const std::vector<TPoint2D>& hits) {
  if (arrived(robot)) return {};
  const TPoint2D point = aim(robot, hits);
  const double error = errorTo(point, robot);
  turning_ = std::abs(error) > (turning_ ? kEndTurn : kBeginTurn);
  const double fastest = params_.turn_deg_s * kDegree;
  VelocityCommand out{0, std::clamp(kTurnGain * error, -fastest, fastest)};
  if (turning_) return out;
  const double braking = kBrakeGain * geometry::distance(route_.back(), robot);
  out.forward_m_s = std::max(kSlowest_m_s, std::min(params_.speed_m_s, braking)) * std::cos(error);
  return out;
}

}  // namespace ariadne::explore
