// What one range looks like over many scans: from how many places, in which directions, beside
// what.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "raw_step.h"

namespace ariadne::io {

/// Ranges in whole millimetres; 0 where the file has none or one at the maximum range or beyond.
struct SurveyedScan {
  std::vector<std::int32_t> ranges_mm;
  double first_rad = 0;  ///< direction of the first beam in the odometry's frame
  double step_rad = 0;   ///< from beam to beam
};

SurveyedScan surveyed(const RawStep& step);

/// Two codes of one log lie this near to each other, as do the roundings of one code.
constexpr std::int32_t kMates_mm = 100;

struct Sightings {
  std::size_t scans = 0;
  /// Of these, where neighbouring beams of this range, among them those of its mates, come to 45
  /// degrees or more.
  std::size_t wide_scans = 0;
  /// Of eight directions in the odometry's frame, those with a twentieth of the scans at least.
  std::size_t directions = 0;
  /// How many different ranges the nearer beams beside it have, in steps of 0.25 m, rare ones
  /// counting less; of the two sides' nearer and farther the fewer. A wall goes on in the beams
  /// beside, a code has anything there.
  double surroundings = 0;
};

/// `passed_over_mm`: a few ranges that are as if they were not there, since they may be codes, too.
Sightings sightingsOf(std::int32_t range_mm, const std::vector<std::int32_t>& passed_over_mm,
                      const std::deque<SurveyedScan>& scans);

}  // namespace ariadne::io
