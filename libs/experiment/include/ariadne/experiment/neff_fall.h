// How fast Neff falls where a recorded drive is on new ground and where it drives a place again:
// from the steps.csv of ariadne-slam and the true path.
#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "ariadne/eval/path_passes.h"

namespace ariadne::experiment {

/// One update of a run as far as Neff goes.
struct NeffStep {
  double time_s = 0;
  double neff = 0;  ///< before resampling
  bool resampled = false;
  double particles = 0;
};

/// The columns of a steps.csv that tell Neff. Throws core::Error naming file and line.
std::vector<NeffStep> readNeffSteps(const std::filesystem::path& file);

/// One update: the change of ln Neff since the update before, resampling taken out (Neff starts
/// from N after one).
struct NeffChange {
  double travelled_m = 0;  ///< true path up to this update
  double length_m = 0;     ///< of true path since the one before
  std::size_t passes = 0;
  double ln_change = 0;
  bool resampled = false;
};

/// An entry for each step but the first.
std::vector<NeffChange> neffChanges(const std::vector<NeffStep>& steps,
                                    const std::vector<eval::PathPoint>& truth);

/// Sums over the updates whose place had been passed so often before.
struct NeffFall {
  double travelled_m = 0;
  double ln_change = 0;
  std::size_t resamplings = 0;
};

/// By earlier passes: none, one, two, three and more.
std::array<NeffFall, 4> neffFall(const std::vector<NeffChange>& changes);

}  // namespace ariadne::experiment
