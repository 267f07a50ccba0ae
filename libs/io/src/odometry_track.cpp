#include "odometry_track.h"

#include <algorithm>
#include <cmath>

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

/// The pose at share `s` of the way from a to b, turning the short way round.
TPose2D between(const TPose2D& a, const TPose2D& b, double s) {
  if (s >= 1) return b;  // to the bit
  const double turn = std::remainder(b.phi - a.phi, 2 * M_PI);
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), std::remainder(a.phi + s * turn, 2 * M_PI)};
}

}  // namespace

bool OdometryTrack::useKind(Kind kind) {
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
  const double latest_s = readings_.empty() ? 0 : readings_.back().first;
  gate_.push(reading.time_s.value_or(latest_s), reading.odom_from_robot);
  takeReadings();
}

bool OdometryTrack::poseOfScan(const std::optional<TPose2D>& line_pose, TPose2D& pose) {
  // While the kind is unknown nothing has moved yet, if increments are what will come.
  pose = sum_;
  if (!line_pose) return true;
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
  while (auto reading = gate_.pop()) readings_.push_back(*reading);
  counts_.odometry_backwards = gate_.rejected();
  // One reading at or before the last scan served is enough; without scans, a bounded number.
  while (readings_.size() > 1 &&
         ((served_s_ && readings_[1].first <= *served_s_) || readings_.size() > kMostReadings))
    readings_.pop_front();
}

bool OdometryTrack::locate(models::SensorStep& step) {
  takeReadings();
  const bool complete = finished_ || waiting_.size() > kMostWaiting;
  if (readings_.empty() || (readings_.back().first < step.time_s && !complete)) return false;
  std::size_t after = 0;
  while (after < readings_.size() && readings_[after].first < step.time_s) ++after;
  const std::size_t before = after == 0 ? 0 : after - 1;
  if (after == readings_.size()) after = before;
  const auto& [time_before, pose_before] = readings_[before];
  const auto& [time_after, pose_after] = readings_[after];
  const double span = time_after - time_before;
  const double share = span > 0 ? std::clamp((step.time_s - time_before) / span, 0.0, 1.0) : 0;
  step.odom_from_robot = between(pose_before, pose_after, share);
  const double nearest =
      std::min(std::abs(step.time_s - time_before), std::abs(time_after - step.time_s));
  if (nearest > kGap_s) ++counts_.odometry_gaps;
  served_s_ = step.time_s;
  return true;
}

std::optional<models::SensorStep> OdometryTrack::pop() {
  if (waiting_.empty() || kind_ == Kind::unknown) return std::nullopt;
  if (kind_ == Kind::readings && !locate(waiting_.front())) return std::nullopt;
  models::SensorStep step = std::move(waiting_.front());
  waiting_.pop_front();
  return step;
}

}  // namespace ariadne::io
