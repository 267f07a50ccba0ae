#include "odometry_track.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;

constexpr double kLongestIncrement_m = 100;
constexpr double kFarthest_m = 1e7;
constexpr double kGap_s = 1;
constexpr std::size_t kMostWaiting = 1000;
constexpr std::size_t kMostReadings = 100'000;

bool isPossible(const TPose2D& p, double farthest_m) {
  return std::abs(p.x) < farthest_m && std::abs(p.y) < farthest_m && std::abs(p.phi) < 1e6;
}

/// The pose at share `s` of the motion from a to b, turning by the shorter arc.
TPose2D between(const TPose2D& a, const TPose2D& b, double s) {
  if (s >= 1) return b;  // to the bit
  const double turn = std::remainder(b.phi - a.phi, 2 * M_PI);
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), std::remainder(a.phi + s * turn, 2 * M_PI)};
}

std::size_t difference(std::size_t a, std::size_t b) { return a > b ? a - b : b - a; }

}  // namespace

bool OdometryTrack::useKind(Kind kind) {
  if (kind_ == Kind::none) return false;
  if (kind_ == Kind::unknown) kind_ = kind;
  if (kind_ != kind) ++counts_.odometry_ignored;
  return kind_ == kind;
}

void OdometryTrack::add(const OdometryIncrement& increment) {
  if (!useKind(Kind::increments)) return;
  if (!isPossible(increment.robot_from_next, kLongestIncrement_m)) {
    ++counts_.odometry_malformed;
    return;
  }
  sum_ = sum_ + increment.robot_from_next;
  sum_.phi = std::remainder(sum_.phi, 2 * M_PI);
}

void OdometryTrack::add(const OdometryReading& reading) {
  if (!useKind(Kind::readings)) return;
  if (!label_) label_ = reading.label;
  if (*label_ != reading.label) {
    ++counts_.odometry_ignored;
    return;
  }
  if (!isPossible(reading.odom_from_robot, kFarthest_m)) {
    ++counts_.odometry_malformed;
    return;
  }
  last_read_s_ = reading.time_s.value_or(last_read_s_);
  gate_.push(last_read_s_, {reading.odom_from_robot, readings_read_++, last_read_s_});
  takeReadings();
}

bool OdometryTrack::poseOfScan(const std::optional<TPose2D>& line_pose, TPose2D& pose) {
  // While the kind is unknown nothing has moved yet, if increments are what will come.
  pose = sum_;
  if (!line_pose || kind_ == Kind::none) return true;
  pose = *line_pose;
  if (!useKind(Kind::lines)) return false;
  if (isPossible(pose, kFarthest_m)) return true;
  ++counts_.odometry_malformed;
  return false;
}

void OdometryTrack::finish() {
  finished_ = true;
  gate_.finish();
}

void OdometryTrack::takeReadings() {
  while (auto passed = gate_.pop()) {
    Reading& reading = readings_.emplace_back(passed->second);
    jumps_ += jumped_(reading.odom_from_robot, reading.time_s);
    reading.jumps = jumps_;
  }
  counts_.odometry_backwards = gate_.rejected();
  counts_.odometry_clock = gate_.setBacks();
  while (readings_.size() > kMostReadings) readings_.pop_front();  // a log without scans
}

std::optional<OdometryTrack::Pair> OdometryTrack::readingsAbout(const Waiting& scan) const {
  const double time_s = scan.step.time_s;
  std::optional<Pair> best;
  std::size_t best_distance = 0;
  for (std::size_t i = 1; i < readings_.size(); ++i) {
    const Reading& a = readings_[i - 1];
    const Reading& b = readings_[i];
    Pair pair{i - 1, i};
    if (a.time_s > b.time_s) {  // the clock was set back: the stamp is of just before or just after
      if (time_s > a.time_s && time_s - a.time_s <= kGap_s)
        pair.after = pair.before;
      else if (time_s <= b.time_s && b.time_s - time_s <= kGap_s)
        pair.before = pair.after;
      else
        continue;
    } else if (time_s <= a.time_s || time_s > b.time_s) {
      continue;
    }
    const std::size_t distance = difference(b.number, scan.place);
    if (best && distance >= best_distance) continue;
    best = pair;
    best_distance = distance;
  }
  return best;
}

std::size_t OdometryTrack::nearestReading(const Waiting& scan) const {
  const auto nearest = [&](const auto& distance) {
    return static_cast<std::size_t>(std::min_element(readings_.begin(), readings_.end(),
                                                     [&](const Reading& a, const Reading& b) {
                                                       return distance(a) < distance(b);
                                                     }) -
                                    readings_.begin());
  };
  const auto gap_s = [&](const Reading& r) { return std::abs(r.time_s - scan.step.time_s); };
  const std::size_t in_time = nearest(gap_s);
  if (gap_s(readings_[in_time]) <= kGap_s) return in_time;
  return nearest([&](const Reading& r) { return difference(r.number, scan.place); });
}

bool OdometryTrack::locate(Waiting& scan) {
  takeReadings();
  if (readings_.empty()) return false;
  const double time_s = scan.step.time_s;
  const bool complete = finished_ || waiting_.size() > kMostWaiting;
  // What follows the scan in the file must have been seen: the clock may be set back there.
  if (!complete && readings_.back().number < scan.place) return false;
  auto pair = readingsAbout(scan);
  if (!pair && !complete && readings_.back().time_s < time_s) return false;
  if (!pair) {
    const std::size_t nearest = nearestReading(scan);
    pair = Pair{nearest, nearest};
  }
  if (readings_[pair->before].jumps != readings_[pair->after].jumps) {  // no motion joins the two
    const bool later =
        time_s - readings_[pair->before].time_s > readings_[pair->after].time_s - time_s;
    (later ? pair->before : pair->after) = later ? pair->after : pair->before;
  }
  const Reading& before = readings_[pair->before];
  const Reading& after = readings_[pair->after];
  const double span = after.time_s - before.time_s;
  const double share = span > 0 ? std::clamp((time_s - before.time_s) / span, 0.0, 1.0) : 0;
  scan.step.odom_from_robot = between(before.odom_from_robot, after.odom_from_robot, share);
  const double nearest_s =
      std::min(std::abs(time_s - before.time_s), std::abs(after.time_s - time_s));
  if (nearest_s > kGap_s) ++counts_.odometry_gaps;
  scan.step.odometry_jumped = last_ && before.jumps != jumps_served_;
  jumps_served_ = before.jumps;
  readings_.erase(readings_.begin(), readings_.begin() + static_cast<std::ptrdiff_t>(pair->before));
  return true;
}

void OdometryTrack::countJump(const models::SensorStep& step) {
  OdometryJumps& jumps = counts_.odometry_jumps;
  if (jumps.count++ > 0) return;
  const TPose2D motion = geometry::relativePose(last_->odom_from_robot, step.odom_from_robot);
  jumps.scan = scans_;
  jumps.time_s = step.time_s;
  jumps.span_s = step.time_s - last_->time_s;
  jumps.distance_m = std::hypot(motion.x, motion.y);
  jumps.turn_deg = std::abs(motion.phi) * 180 / M_PI;
}

std::optional<RawStep> OdometryTrack::pop() {
  if (waiting_.empty() || kind_ == Kind::unknown) return std::nullopt;
  if (kind_ == Kind::readings && !locate(waiting_.front())) return std::nullopt;
  RawStep step = std::move(waiting_.front().step);
  waiting_.pop_front();
  if (kind_ != Kind::readings) step.odometry_jumped = jumped_(step.odom_from_robot, step.time_s);
  ++scans_;
  if (step.odometry_jumped) countJump(step);
  last_ = {step.time_s, step.odom_from_robot, nullptr};
  return step;
}

}  // namespace ariadne::io
