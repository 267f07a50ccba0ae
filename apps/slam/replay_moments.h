// What happened at loops, for the list of moments in report.html.
#pragma once
#include <string>
#include <vector>

#include "ariadne/loops/closing/closing_record.h"
#include "ariadne/report/replay.h"
#include "ariadne/slam/step_report.h"

namespace ariadne::slam_app {

/// Detection, entry, end and recovery of each closing, by the numbers of loops.json.
std::vector<report::ReplayMoment> momentsOf(const std::vector<loops::ClosingRecord>& closings);

/// What the robot is at, by its loop state.
std::string stateInWords(const slam::StepReport& report);

}  // namespace ariadne::slam_app
