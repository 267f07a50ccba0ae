// What is kept of a run: one file of a results folder.
#pragma once
#include <string>

#include "ariadne/batch/success.h"

namespace ariadne::batch {

/// What is kept of one run: the file runs/KEY.json.
struct RunResult {
  std::string key;
  std::string about;       ///< "seed 3, laps 10, frontier": the run that was asked for first
  std::string failure;     ///< empty: the program did its work
  std::string last_words;  ///< end of its stderr, of a failed run
  double wall_s = 0;
  double cpu_s = 0;
  std::string host;
  Figures figures;
};

/// NaN is null in it.
std::string resultText(const RunResult& result);
/// Throws core::Error that calls the file `name` when the text is no result.
RunResult parseResult(const std::string& text, const std::string& name);

}  // namespace ariadne::batch
