#include "loop_counts.h"

namespace ariadne::slam_app {

LoopCounts countLoops(const std::vector<loops::ClosingRecord>& closings) {
  LoopCounts counts;
  counts.detected = closings.size();
  for (const loops::ClosingRecord& c : closings) {
    counts.closed += c.closing.entered ? 1 : 0;
    counts.recovered += c.recovery ? 1 : 0;
  }
  return counts;
}

}  // namespace ariadne::slam_app
