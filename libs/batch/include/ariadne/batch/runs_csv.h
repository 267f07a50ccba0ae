// All runs of an experiment as a CSV file: what tables and plots are made of.
#pragma once
#include <map>
#include <string>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/run_result.h"

namespace ariadne::batch {

/// A line a run that has a result, in the plan's order: seed, values of the factors, arm, whether
/// it failed, whether it was a success (1 or 0; empty where nothing is judged or it failed), and
/// Plan::figures with all digits. No times, hosts or paths: the same runs are the same bytes.
std::string runsCsv(const Plan& plan, const std::map<std::string, RunResult>& results);

}  // namespace ariadne::batch
