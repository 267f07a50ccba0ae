// Log odds of cells that were only ever seen free: 0, f, 2f, .. and at last kMostFree, where f is
// the evidence of one beam. How often a cell was seen free says it all.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "ariadne/grid/tiles/log_odds.h"

namespace ariadne::grid {

/// Between counts of free evidence and log odds: the r-th beam through a cell adds the same amount,
/// up to the most.
class FreeCounts {
 public:
  static constexpr int kNone = 255;

  /// The one for f = `amount` in [1, 127]; it lives for ever.
  static const FreeCounts& of(std::int8_t amount);

  /// Log odds that one beam adds.
  std::int8_t amount() const { return amount_; }
  /// The count from which on a cell is kMostFree; none goes higher.
  int most() const { return most_; }
  /// Bits of most().
  int planes() const { return planes_; }
  /// Of a cell that was seen free this often.
  std::int8_t logOdds(int count) const {
    return static_cast<std::int8_t>(std::min(count * amount_, int{kMostFree}));
  }
  /// The count that stands for these log odds; kNone when none does.
  int countOf(std::int8_t log_odds) const { return counts_[static_cast<std::uint8_t>(log_odds)]; }

 private:
  explicit FreeCounts(int amount);
  std::int8_t amount_;
  int most_;
  int planes_ = 0;
  std::array<std::uint8_t, 256> counts_;
};

}  // namespace ariadne::grid
