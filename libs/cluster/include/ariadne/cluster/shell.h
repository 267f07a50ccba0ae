// Words of a command for a shell, and the worker's.
#pragma once
#include <filesystem>
#include <string>

namespace ariadne::cluster {

/// One word, whatever is in it.
std::string shellWord(const std::string& word);

/// The worker that does one slice, the same on every machine.
struct WorkerCall {
  std::filesystem::path program;  ///< ariadne-experiment
  std::filesystem::path folder;   ///< of the results
  std::size_t slices = 1;
  int jobs = 1;     ///< runs at a time
  int threads = 1;  ///< of a run
};

}  // namespace ariadne::cluster
