// Does the runs of a plan that have no result yet, several at a time.
#pragma once
#include <cstddef>
#include <functional>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"

namespace ariadne::batch {

/// Told after every run that came to its end.
struct ScheduleProgress {
  std::size_t finished = 0;  ///< of `planned`, with those that were before
  std::size_t planned = 0;   ///< different runs of the slice
  double left_s = 0;         ///< estimate, by the runs of this call
  std::string about;
  const RunResult* result = nullptr;
};

/// How many runs at once, which of them, when to stop, who is told.
struct ScheduleOptions {
  int jobs = 1;
  std::size_t slice = 1;  ///< 1 to slices: every slices-th run from there
  std::size_t slices = 1;
  std::function<bool()> stop = [] { return false; };
  std::function<void(const ScheduleProgress&)> tell = [](const ScheduleProgress&) {};
};

/// What a call of the scheduler came to.
struct ScheduleEnd {
  std::size_t done = 0;    ///< in this call
  std::size_t failed = 0;  ///< of those
  bool stopped = false;    ///< before all had a result
  double wall_s = 0;
  double runs_cpu_s = 0;
  double own_cpu_s = 0;  ///< of this process since its start, without the runs
};

/// Other processes and machines may work on the same folder at the same time: each run is done
/// once, and when others do the last ones this waits for them. Results are the runs' alone; a run
/// that fails is a result. Throws core::Error when a result cannot be written or a program or data
/// file is not what it was at planning; finished runs stay, others are killed.
ScheduleEnd doRuns(const Store& store, const Plan& plan, const ScheduleOptions& options);

}  // namespace ariadne::batch
