// Whether a run's input and its result make sense together, and what is said about it.
#pragma once
#include "ariadne/core/error.h"
#include "ariadne/slam/mapper.h"
#include "summary.h"

namespace ariadne::slam_app {

/// Fills the checks of a result, all else of it but truth and replay being there, and adds what
/// they warn of to its warnings.
void checkRun(RunResult& result);

/// Why there was no filter update at all.
core::Error nothingMapped(const SlamConfig& config, const MappingRecord& record,
                          const slam::Mapper& mapper);

}  // namespace ariadne::slam_app
