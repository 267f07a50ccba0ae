#include "surveyed_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace ariadne::io {
namespace {

constexpr double kWide_rad = M_PI / 4;
constexpr float kFarthestReading_m = 1000;
constexpr std::int32_t kSurroundings_mm = 250;

/// How many ranges there are as many of as of each other, if they were equally frequent: the
/// inverse of Simpson's index.
class Variety {
 public:
  void add(std::int32_t range_mm) {
    ++counts_[static_cast<std::size_t>(range_mm / kSurroundings_mm) % counts_.size()];
  }
  double variety() const {
    double sum = 0, squares = 0;
    for (const std::uint32_t n : counts_) {
      sum += n;
      squares += static_cast<double>(n) * n;
    }
    return squares > 0 ? sum * sum / squares : 0;
  }

 private:
  std::array<std::uint32_t, 256> counts_{};
};

/// Follows one range through scans, beam by beam.
class Looking {
 public:
  Looking(std::int32_t range_mm, const std::vector<std::int32_t>& passed_over_mm, Sightings& found)
      : range_mm_(range_mm), passed_over_mm_(passed_over_mm), found_(found) {}
  void at(const SurveyedScan& scan) {
    std::optional<std::int32_t> before;  // the last reading that is clearly nearer
    bool since = false, seen = false, wide = false;
    std::size_t together = 0;
    for (std::size_t i = 0; i < scan.ranges_mm.size(); ++i) {
      const std::int32_t here_mm = scan.ranges_mm[i];
      if (here_mm == range_mm_) {
        if (!seen) noteDirection(scan, i);
        since = seen = true;
        wide |= static_cast<double>(together++) * std::abs(scan.step_rad) >= kWide_rad;
      } else if (here_mm > 0 && here_mm < range_mm_ - kMates_mm) {
        if (isPassedOver(here_mm)) continue;
        if (since) noteSurroundings(before.value_or(here_mm), here_mm);
        before = here_mm;
        since = false;
        together = 0;
      } else if (here_mm == 0 || here_mm > range_mm_ + kMates_mm) {
        together = 0;
      }
    }
    if (since && before) noteSurroundings(*before, *before);
    found_.scans += seen ? 1 : 0;
    found_.wide_scans += wide ? 1 : 0;
  }
  void finish() {
    const std::size_t few = std::max<std::size_t>(2, found_.scans / 20);
    found_.directions = static_cast<std::size_t>(
        std::count_if(sectors_.begin(), sectors_.end(), [&](std::size_t n) { return n >= few; }));
    found_.surroundings = std::min(nearer_.variety(), farther_.variety());
  }

 private:
  bool isPassedOver(std::int32_t range_mm) const {
    return std::find(passed_over_mm_.begin(), passed_over_mm_.end(), range_mm) !=
           passed_over_mm_.end();
  }
  void noteSurroundings(std::int32_t left_mm, std::int32_t right_mm) {
    nearer_.add(std::min(left_mm, right_mm));
    farther_.add(std::max(left_mm, right_mm));
  }
  void noteDirection(const SurveyedScan& scan, std::size_t beam) {
    const double turns = (scan.first_rad + scan.step_rad * static_cast<double>(beam)) / (2 * M_PI);
    const auto sector = static_cast<std::size_t>((turns - std::floor(turns)) * 8);
    ++sectors_[std::min<std::size_t>(sector, 7)];
  }

  std::int32_t range_mm_;
  const std::vector<std::int32_t>& passed_over_mm_;
  Sightings& found_;
  std::array<std::size_t, 8> sectors_{};
  Variety nearer_, farther_;
};

}  // namespace

SurveyedScan surveyed(const RawStep& step) {
  const auto& scan = *step.scan;
  SurveyedScan out;
  const std::size_t size = step.beams.ranges_m.size();
  const double side = scan.rightToLeft ? 1 : -1;
  out.step_rad = side * scan.aperture / static_cast<double>(std::max<std::size_t>(size, 2) - 1);
  out.first_rad = step.odom_from_robot.phi + scan.sensorPose.yaw() - side * scan.aperture / 2;
  out.ranges_mm.resize(size);
  const float limit_m = std::min(scan.maxRange, kFarthestReading_m);
  const float* ranges = step.beams.ranges_m.data();
  const char* valid = step.beams.valid.data();
  std::int32_t* ranges_mm = out.ranges_mm.data();
  for (std::size_t i = 0; i < size; ++i) {
    const float range = ranges[i];
    // NaN is not within either.
    const bool within = (valid[i] != 0) & (range > 0) & (range < limit_m);
    ranges_mm[i] = static_cast<std::int32_t>((within ? range : 0) * 1000 + 0.5F);
  }
  return out;
}

Sightings sightingsOf(std::int32_t range_mm, const std::vector<std::int32_t>& passed_over_mm,
                      const std::deque<SurveyedScan>& scans) {
  Sightings found;
  Looking looking(range_mm, passed_over_mm, found);
  for (const SurveyedScan& scan : scans) looking.at(scan);
  looking.finish();
  return found;
}

}  // namespace ariadne::io
