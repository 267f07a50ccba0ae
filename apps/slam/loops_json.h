// loops.json: what happened at each loop, and by which definitions.
#pragma once
#include <string>
#include <vector>

#include "ariadne/loops/closing/closing_record.h"
#include "ariadne/slam/step_report.h"

namespace ariadne::slam_app {

/// @param reports one a filter update, for the times
/// @param bounds by which the opportunities were found
std::string loopsJson(const std::vector<loops::ClosingRecord>& closings,
                      const std::vector<loops::FoundClosure>& found,
                      const std::vector<slam::StepReport>& reports,
                      const loops::OpportunityParams& bounds);

/// Closings whose saved sets took too much memory: there is something to turn. That a log ended
/// within a loop, or that recovery is off, stands in loops.json alone.
std::vector<std::string> loopWarnings(const std::vector<loops::ClosingRecord>& closings);

}  // namespace ariadne::slam_app
