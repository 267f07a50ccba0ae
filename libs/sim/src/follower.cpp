#include "follower.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::sim {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kReached_m = 0.3;
constexpr double kLookahead_m = 1;
constexpr double kDegree = M_PI / 180;
// Turning on the spot begins and ends at different errors, or the robot would dither.
constexpr double kBeginTurn = 35 * kDegree;
constexpr double kEndTurn = 6 * kDegree;
constexpr double kTurnGain = 2.5;  // rad/s per rad; damped with the motors' lag of 0.1 s
constexpr double kBrakeGain = 1;   // m/s per m before a corner
constexpr double kCornerSpeed_m_s = 0.2;

}  // namespace

Follower::Follower(const std::vector<Waypoint>& waypoints, const TPose2D& start,
                   const DriveParams& params)
    : waypoints_(waypoints),
      params_(params),
      fastest_turn_(params.turn_deg_s * kDegree),
      leg_from_(start.x, start.y) {}

void Follower::see(const TPose2D& robot) {
  while (!done() && geometry::distance(target(), robot) <= kReached_m) {
    leg_from_ = target();
    ++reached_;
  }
}

TPoint2D Follower::aim(const TPose2D& robot) const {
  const double leg_x = target().x - leg_from_.x;
  const double leg_y = target().y - leg_from_.y;
  const double length = std::hypot(leg_x, leg_y);
  if (length < kReached_m) return target();
  const double along = ((robot.x - leg_from_.x) * leg_x + (robot.y - leg_from_.y) * leg_y) / length;
  const double share = std::clamp(along + kLookahead_m, 0.0, length) / length;
  return {leg_from_.x + share * leg_x, leg_from_.y + share * leg_y};
}

bool Follower::sharpCornerAtTarget() const {
  if (reached_ + 1 == waypoints_.size()) return true;  // to stand at the end
  const TPoint2D& next = waypoints_[reached_ + 1].at;
  const double in = std::atan2(target().y - leg_from_.y, target().x - leg_from_.x);
  const double out = std::atan2(next.y - target().y, next.x - target().x);
  return std::abs(std::remainder(out - in, 2 * M_PI)) > kBeginTurn;
}

double Follower::speedTo(double distance_m) const {
  if (!sharpCornerAtTarget()) return params_.speed_m_s;
  const double left = std::max(0.0, distance_m - kReached_m);
  return std::min(params_.speed_m_s, kCornerSpeed_m_s + kBrakeGain * left);
}

models::VelocityCommand Follower::command(const TPose2D& robot) {
  if (done()) return {};
  const TPoint2D point = aim(robot);
  const double error =
      std::remainder(std::atan2(point.y - robot.y, point.x - robot.x) - robot.phi, 2 * M_PI);
  turning_ = std::abs(error) > (turning_ ? kEndTurn : kBeginTurn);
  models::VelocityCommand out;
  out.turn_rad_s = std::clamp(kTurnGain * error, -fastest_turn_, fastest_turn_);
  if (!turning_) out.forward_m_s = speedTo(geometry::distance(target(), robot)) * std::cos(error);
  return out;
}

double Follower::patience(const TPose2D& robot) const {
  if (done()) return 0;
  constexpr double kMargin_s = 10;
  const double slowest = std::min(params_.speed_m_s, kCornerSpeed_m_s);
  const double corners_s = 2 * kLookahead_m / slowest + 4 * M_PI / fastest_turn_;
  return kMargin_s + corners_s + 2 * geometry::distance(target(), robot) / params_.speed_m_s;
}

}  // namespace ariadne::sim
