// The files of a run.
#pragma once
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "ariadne/slam/mapper.h"
#include "summary.h"

namespace ariadne::slam_app {

/// Names of all files that a run with this configuration writes.
std::vector<std::string> outputNames(const SlamConfig& config);

/// Writes all files, each whole or not at all, and says on `out` what each is for. One that fails
/// does not keep the others from being written; then throws core::Error that names those that
/// failed. Throws core::Error at once when the map is empty.
void writeOutputs(const std::filesystem::path& folder, const slam::Mapper& mapper,
                  const RunResult& result, std::ostream& out);

}  // namespace ariadne::slam_app
