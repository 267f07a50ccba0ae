// A run's results by their names, as its summary.json has them.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ariadne/experiment/oracle.h"

namespace ariadne::experiment {

/// Truth values are 0 and 1; what a run has not is NaN or left out.
using RunFigures = std::vector<std::pair<std::string, double>>;

/// By name.
RunFigures figuresOf(const LoopRunResult& result);
/// The oracle has no KL: the others' is from its set.
RunFigures figuresOf(const OracleResult& result);

}  // namespace ariadne::experiment
