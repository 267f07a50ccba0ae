#include "ariadne/explore/left_loops.h"

#include <algorithm>
#include <cmath>

#include "ariadne/explore/goal_check.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

constexpr double kAbout_m = 2;  // what belongs to an entry
// A step of the floor 0.7 m square. Less comes and goes where walls are drawn anew by each scan and
// where another particle becomes s*.
constexpr double kChanged_m2 = 0.5;

}  // namespace

void LeftLoops::add(const loops::Closing& loop, const grid::OccupancyGrid& map) {
  if (loop.entered)
    entered_.push_back(loop.id);
  else
    entries_.push_back(
        {loop.id, loop.entry_position, freeArea(map, loop.entry_position, kAbout_m)});
}

void LeftLoops::forgetWhereChanged(const grid::OccupancyGrid& map) {
  const auto changed = [&](const Entry& e) {
    return std::abs(freeArea(map, e.at, kAbout_m) - e.free_m2) >= kChanged_m2;
  };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), changed), entries_.end());
}

bool LeftLoops::contains(const loops::Closing& loop) const {
  return std::find(entered_.begin(), entered_.end(), loop.id) != entered_.end() ||
         std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
           return e.closing == loop.id ||
                  (!loop.entered && geometry::distance(e.at, loop.entry_position) < kAbout_m);
         });
}

}  // namespace ariadne::explore
