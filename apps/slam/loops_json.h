// loops.json: what happened at each loop, and by which definitions.
#pragma once
#include <string>
#include <vector>

#include "ariadne/slam/closing_record.h"
#include "ariadne/slam/step_report.h"

namespace ariadne::slam_app {

/// @param reports one a filter update, for the times
/// @param bounds by which the opportunities were found
std::string loopsJson(const std::vector<slam::ClosingRecord>& closings,
                      const std::vector<slam::FoundClosure>& found,
                      const std::vector<slam::StepReport>& reports,
                      const topology::OpportunityParams& bounds);

/// What a user should know of closings that did not come to a recovery.
std::vector<std::string> loopWarnings(const std::vector<slam::ClosingRecord>& closings);

}  // namespace ariadne::slam_app
