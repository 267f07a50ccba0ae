// Results of paired runs as rows of a CSV file, one a run, so that an experiment that was stopped
// goes on where it was.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/experiment/loop_run.h"

namespace ariadne::experiment {

struct LoopRow {
  std::string name;  ///< of the drive: its path file
  int laps = 0;
  std::uint64_t seed = 0;
  LoopRunResult result;
};

/// A header and a line a row; numbers read back to the same bits.
std::string toCsv(const std::vector<LoopRow>& rows);
/// Throws core::Error naming file and line when it is not such a file.
std::vector<LoopRow> readRows(const std::filesystem::path& file);

}  // namespace ariadne::experiment
