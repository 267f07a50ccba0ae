#include "ariadne/grid/tiles/free_counts.h"

#include <vector>

namespace ariadne::grid {

FreeCounts::FreeCounts(int amount)
    : amount_(static_cast<std::int8_t>(amount)), most_((kMostFree + amount - 1) / amount) {
  while (most_ >> planes_ != 0) ++planes_;
  counts_.fill(kNone);
  for (int n = most_; n >= 0; --n)
    counts_[static_cast<std::uint8_t>(logOdds(n))] = static_cast<std::uint8_t>(n);
}

const FreeCounts& FreeCounts::of(std::int8_t amount) {
  static const auto all = [] {
    std::vector<FreeCounts> table;
    for (int f = 1; f <= kMostFree; ++f) table.push_back(FreeCounts(f));
    return table;
  }();
  return all.at(static_cast<std::size_t>(amount - 1));
}

}  // namespace ariadne::grid
