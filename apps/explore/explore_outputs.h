// The files of an exploration: those of ariadne-slam for its drive, and its own.
#pragma once
#include "exploration.h"
#include "outputs.h"

namespace ariadne::explore_app {

/// @param result is read when the files are written; it must outlive them
std::vector<slam_app::Output> outputsOf(const ExploreConfig& config,
                                        const ExplorationResult& result);

/// The text of summary.json.
std::string summaryText(const ExplorationResult& result, double writing_s,
                        const std::vector<std::string>& files);

/// What was recorded, with what the run knows now.
report::Replay replayOf(report::ReplayRecorder& recorder, const slam::Mapper& mapper,
                        const ExplorationResult& result);

}  // namespace ariadne::explore_app
