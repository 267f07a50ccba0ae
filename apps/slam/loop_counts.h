// How many loops a run saw: for the terminal, summary.json and loops.json alike.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/loops/closing/closing_record.h"

namespace ariadne::slam_app {

struct LoopCounts {
  std::size_t detected = 0;
  std::size_t closed = 0;     ///< the entry was reached
  std::size_t recovered = 0;  ///< the set was replaced afterwards
};

LoopCounts countLoops(const std::vector<loops::ClosingRecord>& closings);

}  // namespace ariadne::slam_app
