// Which readings of a laser mean "nothing there", told from the readings themselves.
//
// Many logs say "no return" by a number below the maximum range: 8.183, 50.0, 51.15, ... Such a
// code is one exact range, above all that the laser measures, that comes back far more often than
// any other, from anywhere, in any direction, beside anything. A wall does not: from another place
// it is at another range, in its direction only, and it goes on in the beams beside.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "raw_step.h"
#include "surveyed_scan.h"

namespace ariadne::io {

class NoReturnSurvey {
 public:
  /// Takes a scan in. One from where the last one was says nothing new and is passed over.
  void add(const RawStep& step);
  /// Looks for codes in what was added so far, if `now` or much is new since the last time.
  void judge(bool now);
  /// Readings at or over this are no return; infinite while no code is known. It only falls.
  float reach_m() const { return reach_m_; }

 private:
  struct Bin {
    std::uint32_t beams = 0;
    std::uint32_t scans = 0;
    std::uint32_t last_scan = 0;  ///< counted from 1
  };
  bool isElsewhere(const mrpt::math::TPose2D& pose);
  void keep(SurveyedScan scan);
  /// Ranges somewhat below one.
  struct Below {
    std::uint32_t busy = 0;               ///< as many beams does a busy one have
    std::vector<std::int32_t> busier_mm;  ///< those that have many times more, at most four
  };
  Below lookBelow(std::size_t range_mm) const;
  bool isCode(std::size_t range_mm, const Below& below) const;
  std::size_t lowestMate(std::size_t code_mm, const Below& below) const;

  std::vector<Bin> bins_;  ///< of each millimetre, over all scans
  std::deque<SurveyedScan> latest_;
  std::size_t latest_beams_ = 0;
  mrpt::math::TPose2D first_pose_, last_pose_;
  bool moved_ = false;
  std::size_t passed_over_ = 0;
  std::uint32_t scans_ = 0;
  std::uint64_t beams_ = 0;  ///< with a range
  std::uint32_t judged_ = 0;
  std::int32_t header_mm_ = 0;  ///< greatest maximum range that a header says
  float reach_m_ = std::numeric_limits<float>::infinity();
};

}  // namespace ariadne::io
