#include "ariadne/batch/run_counts.h"

#include <set>

namespace ariadne::batch {

Counts countRuns(const Plan& plan, const std::map<std::string, RunResult>& results) {
  std::set<std::string> keys;
  for (const PlannedRun& run : plan.runs) keys.insert(run.key);
  Counts counts;
  counts.planned = keys.size();
  for (const auto& [key, result] : results)
    ++(result.failure.empty() ? counts.finished : counts.failed);
  return counts;
}

}  // namespace ariadne::batch
