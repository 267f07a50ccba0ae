// Neff over one drive with its marks, as the paper's Fig. 5: with plain weights and with evidence
// that counts less at each revisit of a place.
#pragma once
#include <filesystem>

#include "ariadne/experiment/loop_config.h"
#include "ariadne/sim/drive.h"

namespace ariadne::eval_app {

/// PNG. Throws core::Error naming the file.
void writeNeffChart(const std::filesystem::path& file, const experiment::LoopConfig& config,
                    const sim::TruthDrive& truth, std::uint64_t seed);

}  // namespace ariadne::eval_app
