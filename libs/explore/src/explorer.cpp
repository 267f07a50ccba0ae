#include "ariadne/explore/explorer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/explore/goal_check.h"
#include "ariadne/explore/guard.h"
#include "ariadne/models/motion_model.h"

namespace ariadne::explore {
namespace {

using models::VelocityCommand;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr int kMostTouches = 20;
constexpr double kGuard_m = 0.1;
constexpr double kBackOff_m_s = 0.15;
constexpr double kBackOff_s = 2;
constexpr double kFacePatience_s = 8;
constexpr double kSameFrontier_m = 0.5;

double distance(const TPoint2D& p, const TPose2D& robot) {
  return std::hypot(p.x - robot.x, p.y - robot.y);
}

}  // namespace

Explorer::Explorer(const ExploreParams& params) : params_(params), follower_(params) {
  core::validateFields(params, "explore");
}

VelocityCommand Explorer::step(const Belief& belief) {
  if (done()) return {};
  const TPose2D pose = belief.mapper.pose();
  if (before_) {
    // A jump of the belief is no way.
    const double moved = std::hypot(pose.x - before_->x, pose.y - before_->y);
    travelled_m_ += std::min(moved, 2 * params_.speed_m_s);
    turned_ += std::abs(std::remainder(pose.phi - before_->phi, 2 * M_PI));
  }
  before_ = pose;
  if (!started_s_) started_s_ = belief.time_s;
  if (travelled_m_ >= params_.max_distance_m) return end(belief, "max_distance_m is driven");
  if (belief.time_s - *started_s_ >= params_.max_time_s) return end(belief, "max_time_s is over");
  if (belief.touched && mode_ != Mode::backing_off) touch(belief);
  if (belief.mapper.updates() > updates_)
    left_.forgetWhereChanged(belief.mapper.particles()[belief.mapper.particles().best()].map);
  const VelocityCommand command = act(belief);
  updates_ = belief.mapper.updates();
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
  if (turned_ >= 2 * M_PI) {
    decide(belief);
    return {};
  }
  return {0, params_.turn_deg_s * M_PI / 180};
}

/// A decision is made anew when a loop opens or closes, and when what it aimed at is gone.
bool Explorer::reconsiders(const Belief& belief) {
  const auto open = belief.mapper.openClosings();
  const bool in_loop = std::any_of(open.begin(), open.end(), [&](const closing::Closing* c) {
    return !left_.contains(*c) && params_.strategy != Strategy::frontier;
  });
  if (in_loop != (goal_ == Goal::entry || goal_ == Goal::loop)) return true;
  if (goal_ == Goal::entry && open.back()->entered) return true;
  // So that it never has to brake.
  constexpr double kNearPlace_m = 1.5;
  const double since_check_m = travelled_m_ - checked_at_m_;
  if (goal_ == Goal::loop && distance(target_, belief.mapper.pose()) < kNearPlace_m &&
      since_check_m > 0.3)
    return true;
  if (belief.time_s - checked_at_s_ >= 5) return true;  // hardly moves
  if (since_check_m < 1) return false;
  checked_at_m_ = travelled_m_;
  checked_at_s_ = belief.time_s;
  return !goalStands(belief);
}

bool Explorer::goalStands(const Belief& belief) const {
  const auto& map = belief.mapper.particles()[belief.mapper.particles().best()].map;
  if (goal_ == Goal::frontier && !bordersUnknown(map, target_, 1.5 * params_.planning_cell_m))
    return false;
  return routeHolds(map, follower_.route(), follower_.next(), belief.mapper.pose(), params_);
}

VelocityCommand Explorer::drive(const Belief& belief) {
  const TPose2D pose = belief.mapper.pose();
  if (reconsiders(belief)) decide(belief);
  if (mode_ != Mode::driving) return {};
  if (follower_.arrived(pose)) {
    if (goal_ == Goal::frontier) {
      mode_ = Mode::facing;
      mode_since_s_ = belief.time_s;
      return {};
    }
    if (goal_ == Goal::home) return end(belief, "explored, and back at the start");
    decide(belief);
    return {};
  }
  VelocityCommand command = follower_.command(pose);
  if (command.forward_m_s > 0 &&
      blocked(hitsOf(belief.scan, 2), kGuard_m + command.forward_m_s * 0.2, params_)) {
    command.forward_m_s = 0;
    if (belief.time_s - decided_at_s_ >= 1) {
      ++lost_;
      decide(belief);
      if (lost_ >= params_.giveup && mode_ == Mode::driving) {
        giveUp(belief, "the way there was blocked again and again");
        if (!done()) decide(belief);
      }
    }
  }
  return command;
}

/// At a frontier: turns to it until the filter took a scan with it in view. One that stays as it
/// was has failed.
VelocityCommand Explorer::face(const Belief& belief) {
  constexpr double kInView = 60 * M_PI / 180;
  const TPose2D pose = belief.mapper.pose();
  const double error =
      std::remainder(std::atan2(target_.y - pose.y, target_.x - pose.x) - pose.phi, 2 * M_PI);
  const bool looked = belief.mapper.updates() > updates_ && std::abs(error) < kInView;
  if (!looked && belief.time_s - mode_since_s_ < kFacePatience_s) {
    const auto command = follower_.face(pose, target_);
    // Past it, for the filter takes a scan only after a turn.
    return command.turn_rad_s != 0 ? command : VelocityCommand{0, params_.turn_deg_s * M_PI / 180};
  }
  const TPoint2D target = target_;
  decide(belief);
  if (mode_ == Mode::driving && goal_ == Goal::frontier &&
      std::hypot(target_.x - target.x, target_.y - target.y) < kSameFrontier_m &&
      follower_.arrived(pose)) {
    failTarget("seen from beside it, it did not give way");
    decide(belief);
  }
  return {};
}

void Explorer::touch(const Belief& belief) {
  ++touches_;
  const TPose2D pose = belief.mapper.pose();
  const double rim = params_.robot_radius_m + 0.05;
  for (int degrees = -40; degrees <= 40; degrees += 10) {
    const double angle = pose.phi + degrees * M_PI / 180;
    touched_at_.emplace_back(pose.x + rim * std::cos(angle), pose.y + rim * std::sin(angle));
  }
  note(belief, DecisionKind::touched, "touched something that the laser does not see: backs off");
  mode_ = Mode::backing_off;
  mode_since_s_ = belief.time_s;
  if (touches_ >= kMostTouches) end(belief, fmt::format("touched something {} times", touches_));
}

VelocityCommand Explorer::backOff(const Belief& belief) {
  if (belief.time_s - mode_since_s_ < kBackOff_s) return {-kBackOff_m_s, 0};
  decide(belief);
  return {};
}

/// What the robot is on its way to is not gone to again.
void Explorer::giveUp(const Belief& belief, const std::string& why) {
  switch (goal_) {
    case Goal::entry:
    case Goal::loop:
      for (const closing::Closing* loop : belief.mapper.openClosings())
        if (loop->name == loop_name_) leave(belief, *loop, why);
      break;
    case Goal::home:
      end(belief, "explored; " + why);
      break;
    case Goal::frontier:
    case Goal::none:
      failTarget(why);
  }
  lost_ = 0;
}

void Explorer::failTarget(const std::string& why) { failed_.push_back({target_, why}); }

void Explorer::go(Goal goal, const TPoint2D& target, Route route) {
  const bool same = goal == goal_ && std::hypot(target.x - target_.x, target.y - target_.y) < 0.5;
  if (!same) lost_ = 0;
  goal_ = goal;
  target_ = target;
  follower_.take(std::move(route));
  mode_ = Mode::driving;
}

VelocityCommand Explorer::end(const Belief& belief, const std::string& reason) {
  end_reason_ = reason;
  note(belief, DecisionKind::end, reason);
  mode_ = Mode::done;
  follower_.take({});
  return {};
}

Decision& Explorer::note(const Belief& belief, DecisionKind kind, const std::string& text) {
  Decision d;
  d.kind = kind;
  d.time_s = belief.time_s;
  d.update = belief.mapper.updates() - 1;
  d.map_from_robot = belief.mapper.pose();
  d.text = text;
  decisions_.push_back(std::move(d));
  return decisions_.back();
}

std::string Explorer::doing() const {
  if (mode_ == Mode::looking_around) return "looking around";
  if (mode_ == Mode::facing) return "looking at a frontier";
  if (mode_ == Mode::backing_off) return "backing off";
  if (mode_ == Mode::done) return "done: " + end_reason_;
  switch (goal_) {
    case Goal::frontier:
      return "driving to a frontier";
    case Goal::entry:
      return "driving to the entry of a loop";
    case Goal::loop:
      return "following a loop";
    case Goal::home:
      return "driving home";
    case Goal::none:
      break;
  }
  return "thinking";
}

}  // namespace ariadne::explore
