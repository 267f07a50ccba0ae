// Loops that the robot has given up: not gone to again until the map at their entry has changed.
#pragma once
#include <vector>

#include "ariadne/loops/closing/loop_watcher.h"

namespace ariadne::explore {

/// Loops that the explorer has left or given up.
class LeftLoops {
 public:
  /// @param map of s* now
  void add(const loops::Closing& loop, const grid::OccupancyGrid& map);
  /// Entries may be gone to again where more or less floor is known than when they were given up.
  /// A loop that was entered stays left.
  void forgetWhereChanged(const grid::OccupancyGrid& map);
  /// A closing of another number with its entry at the same place is the same.
  bool contains(const loops::Closing& loop) const;

 private:
  struct Entry {
    std::size_t closing = 0;
    mrpt::math::TPoint2D at;  // m, map frame
    double free_m2 = 0;
  };
  std::vector<std::size_t> entered_;  // closings
  std::vector<Entry> entries_;        // of those that were not
};

}  // namespace ariadne::explore
