// How far a plan is.
#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/run_result.h"

namespace ariadne::batch {

/// Of the plan's different runs, how many there are of each kind.
struct Counts {
  std::size_t planned = 0;  ///< different runs
  std::size_t finished = 0;
  std::size_t failed = 0;
  /// Runs that have no result yet.
  std::size_t missing() const { return planned - finished - failed; }
};

/// @param results of runs of the plan only
Counts countRuns(const Plan& plan, const std::map<std::string, RunResult>& results);

}  // namespace ariadne::batch
