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

/// Lines of the file, without their ends; numbers read back to the same bits.
std::string rowsHeader();
std::string toLine(const LoopRow& row);
/// Also of earlier versions, whose rows lack the last figures: these are NaN. Throws core::Error
/// naming file and line when it is no such file.
std::vector<LoopRow> readRows(const std::filesystem::path& file);

}  // namespace ariadne::experiment
