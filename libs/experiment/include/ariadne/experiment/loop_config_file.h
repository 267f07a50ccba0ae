// The INI of a loop experiment.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/experiment/loop_config.h"

namespace ariadne::experiment {

/// Defaults, then the INI, then the settings (section.key=value) in order; files are where the INI
/// says. Throws core::UsageError with file, section and key.
/// @param text of `file`
LoopConfig readLoopConfig(const std::filesystem::path& file, const std::string& text,
                          const std::vector<std::string>& settings);

}  // namespace ariadne::experiment
