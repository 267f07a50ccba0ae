#include "no_return_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ariadne/geometry/pose.h"

namespace ariadne::io {
namespace {

// A robot that stands sees the same ranges again and again, walls and codes alike.
constexpr double kElsewhere_m = 0.1;
// Where odometry never moves, one scan in so many is taken for one from elsewhere.
constexpr std::size_t kStandingStride = 10;
constexpr std::size_t kMostBeamsKept = 1'000'000;
constexpr std::uint32_t kScansBetweenJudgements = 64;
// What is nearer may be a part of the robot.
constexpr std::size_t kLeastCode_mm = 2000;
// A code has at most a twentieth of its beams above it.
constexpr std::uint64_t kLeastTimesAbove = 20;
// A code has so many times the beams of busy ranges below it.
constexpr std::uint32_t kTimesBusier = 4;

/// SICK's LMS 2xx sends the last nine of its 13, 14 or 15 bits for "nothing", "dazzled" and the
/// like, in mm or, over 80 m, in cm.
bool isSickCode(std::size_t mm) {
  for (const std::size_t full : {8192U, 16384U, 32768U, 81920U}) {
    const std::size_t unit = full == 81920U ? 10 : 1;
    if (mm < full && mm >= full - 9 * unit) return true;
  }
  return false;
}

}  // namespace

bool NoReturnSurvey::isElsewhere(const mrpt::math::TPose2D& pose) {
  if (scans_ == 0) {
    first_pose_ = pose;
    return true;
  }
  moved_ |= pose.x != first_pose_.x || pose.y != first_pose_.y || pose.phi != first_pose_.phi;
  if (!moved_) return ++passed_over_ % kStandingStride == 0;
  return geometry::distance(pose, last_pose_) >= kElsewhere_m;
}

void NoReturnSurvey::add(const RawStep& step) {
  if (!isElsewhere(step.odom_from_robot)) return;
  last_pose_ = step.odom_from_robot;
  header_mm_ = std::max(header_mm_, static_cast<std::int32_t>(step.scan->maxRange * 1000));
  keep(surveyed(step));
}

void NoReturnSurvey::keep(SurveyedScan scan) {
  ++scans_;
  for (const std::int32_t range_mm : scan.ranges_mm) {
    const auto at = static_cast<std::size_t>(range_mm);
    beams_ += at > 0 ? 1 : 0;
    if (at < kLeastCode_mm) continue;
    if (at >= bins_.size()) bins_.resize(at + 1);
    Bin& bin = bins_[at];
    ++bin.beams;
    if (std::exchange(bin.last_scan, scans_) != scans_) ++bin.scans;
  }
  latest_beams_ += scan.ranges_mm.size();
  latest_.push_back(std::move(scan));
  for (; latest_beams_ > kMostBeamsKept; latest_.pop_front())
    latest_beams_ -= latest_.front().ranges_mm.size();
}

/// From 0.7 of the range up to its mates. Busy is the fifth: other codes may be among them.
NoReturnSurvey::Below NoReturnSurvey::lookBelow(std::size_t range_mm) const {
  std::array<std::size_t, 5> busiest{};  // falling; bin 0 is empty
  const auto beams = [this](std::size_t mm) { return bins_[mm].beams; };
  for (std::size_t mm = range_mm * 7 / 10; mm + kMates_mm < range_mm; ++mm) {
    if (beams(mm) <= beams(busiest.back())) continue;
    busiest.back() = mm;
    for (std::size_t i = busiest.size() - 1; i > 0 && beams(busiest[i]) > beams(busiest[i - 1]);
         --i)
      std::swap(busiest[i], busiest[i - 1]);
  }
  Below below;
  below.busy = beams(busiest.back());
  for (const std::size_t mm : busiest)
    if (beams(mm) > kTimesBusier * below.busy)
      below.busier_mm.push_back(static_cast<std::int32_t>(mm));
  return below;
}

bool NoReturnSurvey::isCode(std::size_t range_mm, const Below& below) const {
  const Bin& bin = bins_[range_mm];
  if (bin.beams < kTimesBusier * below.busy) return false;
  const Sightings seen = sightingsOf(static_cast<std::int32_t>(range_mm), below.busier_mm, latest_);
  const auto header = static_cast<std::size_t>(header_mm_);
  // No wall is equally far over 45 degrees from two places.
  if (isSickCode(range_mm) || range_mm * 100 >= header * 99)
    return seen.wide_scans >= 2 || (seen.scans >= 5 && seen.surroundings >= 3);
  // A log of hardly any other range, though, is somebody's test.
  if (seen.wide_scans >= 5) return beams_ - bin.beams > bin.beams / 100;
  return seen.scans >= 20 && seen.surroundings >= 6 && seen.directions >= 3 &&
         bin.beams >= 2 * kTimesBusier * below.busy;
}

/// Of the ranges just below a code, the lowest that is a code of its own or another rounding.
std::size_t NoReturnSurvey::lowestMate(std::size_t code_mm, const Below& below) const {
  const std::uint32_t few = std::max(2 * below.busy, bins_[code_mm].beams / 200);
  std::size_t lowest = code_mm;
  for (std::size_t mm = code_mm; mm + kMates_mm > code_mm && mm > kLeastCode_mm; --mm)
    if (bins_[mm].beams > few) lowest = mm;
  return lowest;
}

void NoReturnSurvey::judge(bool now) {
  if (scans_ == judged_ || (!now && scans_ < judged_ + kScansBetweenJudgements)) return;
  judged_ = scans_;
  // From the top: a code has next to nothing above it but other codes.
  std::size_t top = bins_.size();
  if (std::isfinite(reach_m_)) top = std::min(top, static_cast<std::size_t>(reach_m_ * 1000) + 1);
  std::uint64_t above = 0;
  for (std::size_t mm = top; mm-- > kLeastCode_mm && above * kLeastTimesAbove <= beams_;) {
    if (mm + kMates_mm < top) above += bins_[mm + kMates_mm].beams;
    const Bin& bin = bins_[mm];
    if (bin.scans < 2 || above * kLeastTimesAbove > bin.beams) continue;
    const Below below = lookBelow(mm);
    if (!isCode(mm, below)) continue;
    top = mm = lowestMate(mm, below);
    above = 0;
    reach_m_ = (static_cast<float>(mm) - 0.5F) / 1000;
  }
}

}  // namespace ariadne::io
