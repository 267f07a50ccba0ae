// The table of the nested-loop experiment.
#pragma once
#include <string>
#include <vector>

#include "ariadne/experiment/run_rows.h"

namespace ariadne::experiment {

/// Markdown: for each drive and number of laps the rates of both arms with Wilson's 95 % intervals,
/// McNemar's exact p of the pairs, and where hypotheses were lost.
std::string loopTable(const std::vector<LoopRow>& rows);

}  // namespace ariadne::experiment
