// The replay of a run for report.html.
#pragma once
#include "ariadne/report/replay_recorder.h"
#include "mapping.h"
#include "summary.h"

namespace ariadne::slam_app {

/// Records each update of the mapper; nothing where no report is wanted. Both must outlive it.
UpdateListener recordingOf(const SlamConfig& config, const slam::Mapper& mapper,
                           report::ReplayRecorder& recorder);

/// What was recorded, with what the run knows now: facts, moments and truth.
/// @param result all of it but the replay
report::Replay replayOf(report::ReplayRecorder& recorder, const slam::Mapper& mapper,
                        const RunResult& result);

}  // namespace ariadne::slam_app
