// What the robot does from scan to scan.
#include "ariadne/explore/explorer.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/explore/guard.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

using models::VelocityCommand;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kDegreeOfExplorer = M_PI / 180;
constexpr int kMostTouches = 20;
constexpr double kGuard_m = 0.1;
constexpr double kScanPeriod_s = 0.2;  // about: how far a command carries
constexpr double kBackOff_m_s = 0.15;
constexpr double kBackOff_s = 2;

}  // namespace

Explorer::Explorer(const ExploreParams& params)
    : params_(params),
      frontier_goal_(params),
      loop_goal_(params),
      home_goal_(params),
      follower_(params),
      bumper_(params.robot_radius_m),
      motion_(2 * params.speed_m_s) {
  core::validateFields(params, "explore");
}

VelocityCommand Explorer::step(const Belief& belief) {
  if (done()) return {};
  motion_.add(belief.map_from_robot);
  if (!started_s_) started_s_ = belief.time_s;
  if (travelled_m() >= params_.max_distance_m) return end(belief, "max_distance_m is driven");
  if (belief.time_s - *started_s_ >= params_.max_time_s) return end(belief, "max_time_s is over");
  if (belief.touched && mode_ != Mode::backing_off) touch(belief);
  if (belief.updates > updates_) loop_goal_.look(belief.map);
  const VelocityCommand command = act(belief);
  updates_ = belief.updates;
  return command;
}

VelocityCommand Explorer::act(const Belief& belief) {
  switch (mode_) {
    case Mode::looking_around:
      return lookAround(belief);
    case Mode::driving:
      return drive(belief);
    case Mode::facing:
      return face(belief);
    case Mode::backing_off:
      return backOff(belief);
    case Mode::done:
      break;
  }
  return {};
}

VelocityCommand Explorer::lookAround(const Belief& belief) {
  if (motion_.turned_rad() < 2 * M_PI) return {0, params_.turn_deg_s * kDegreeOfExplorer};
  decide(belief);
  return {};
}

VelocityCommand Explorer::drive(const Belief& belief) {
  if (mustDecide(belief)) decide(belief);
  if (mode_ != Mode::driving) return {};
  if (follower_.arrived(belief.map_from_robot)) return arrive(belief);
  const std::vector<TPoint2D> hits = hitsOf(belief.scan, 2);
  VelocityCommand command = follower_.command(belief.map_from_robot, hits);
  const double ahead_m = kGuard_m + command.forward_m_s * kScanPeriod_s;
  if (command.forward_m_s > 0 && explore::blocked(hits, ahead_m, params_)) {
    command.forward_m_s = 0;
    blocked(belief);
  }
  return command;
}

VelocityCommand Explorer::arrive(const Belief& belief) {
  if (heading_.purpose == Purpose::home) return end(belief, "explored, and back at the start");
  if (heading_.purpose == Purpose::frontier) {
    mode_ = Mode::facing;
    mode_since_s_ = belief.time_s;
  } else {
    decide(belief);
  }
  return {};
}

/// The laser sees something that the map does not know. Another route may lead around it.
void Explorer::blocked(const Belief& belief) {
  if (belief.time_s - decided_at_s_ < 1) return;
  ++lost_;
  decide(belief);
  if (lost_ < params_.giveup || mode_ != Mode::driving) return;
  giveUp(belief, "the route there was blocked again and again");
  if (!done()) decide(belief);
}

/// At a frontier: turns to it until the filter took a scan with it in view. One that stays as it
/// was has failed.
VelocityCommand Explorer::face(const Belief& belief) {
  constexpr double kInView = 60 * kDegreeOfExplorer;
  constexpr double kPatience_s = 8;
  constexpr double kSame_m = 0.5;
  const TPose2D& pose = belief.map_from_robot;
  const TPoint2D seen = heading_.at;
  const double error =
      std::remainder(std::atan2(seen.y - pose.y, seen.x - pose.x) - pose.phi, 2 * M_PI);
  const bool looked = belief.updates > updates_ && std::abs(error) < kInView;
  if (!looked && belief.time_s - mode_since_s_ < kPatience_s) {
    const auto command = follower_.face(pose, seen);
    // Past it, for the filter takes a scan only after a turn.
    return command.turn_rad_s != 0 ? command
                                   : VelocityCommand{0, params_.turn_deg_s * kDegreeOfExplorer};
  }
  decide(belief);
  const bool still_there = mode_ == Mode::driving && heading_.purpose == Purpose::frontier &&
                           geometry::distance(heading_.at, seen) < kSame_m;
  if (still_there && follower_.arrived(pose)) {
    frontier_goal_.fail(heading_.at, "seen from beside it, it did not give way");
    decide(belief);
  }
  return {};
}

void Explorer::touch(const Belief& belief) {
  bumper_.touch(belief.map_from_robot);
  log_.note(belief, DecisionKind::touched,
            "touched something that the laser does not see: backs off");
  mode_ = Mode::backing_off;
  mode_since_s_ = belief.time_s;
  if (bumper_.touches() >= kMostTouches)
    end(belief, fmt::format("touched something {} times", bumper_.touches()));
}

VelocityCommand Explorer::backOff(const Belief& belief) {
  if (belief.time_s - mode_since_s_ < kBackOff_s) return {-kBackOff_m_s, 0};
  decide(belief);
  return {};
}

VelocityCommand Explorer::end(const Belief& belief, const std::string& reason) {
  end_reason_ = reason;
  log_.note(belief, DecisionKind::end, reason);
  mode_ = Mode::done;
  follower_.take({});
  return {};
}

std::string Explorer::doing() const {
  if (mode_ == Mode::looking_around) return "looking around";
  if (mode_ == Mode::facing) return "looking at a frontier";
  if (mode_ == Mode::backing_off) return "backing off";
  if (mode_ == Mode::done) return "done: " + end_reason_;
  switch (heading_.purpose) {
    case Purpose::frontier:
      return "driving to a frontier";
    case Purpose::entry:
      return "driving to the entry of a loop";
    case Purpose::loop:
      return "following a loop";
    case Purpose::home:
      return "driving home";
    case Purpose::none:
      break;
  }
  return "thinking";
}

}  // namespace ariadne::explore
