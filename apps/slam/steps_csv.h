// steps.csv: what each filter update did, for plots.
#pragma once
#include <string>
#include <vector>

#include "ariadne/slam/step_report.h"

namespace ariadne::slam_app {

/// A header line and a line an update; numbers read back to the same bits.
std::string stepsCsv(const std::vector<slam::StepReport>& reports);

}  // namespace ariadne::slam_app
