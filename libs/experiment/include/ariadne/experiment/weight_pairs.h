// What the weights of a filter knew: pairs of particles of one update, where the truth says which
// of the two was nearer.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ariadne/sim/drive.h"
#include "ariadne/slam/params.h"

namespace ariadne::experiment {

/// Two particles of one update, a the nearer one to the truth.
struct WeightPair {
  std::size_t passes = 0;  ///< times that s* had been at this place before
  double ln_ratio = 0;     ///< ln of a's weight over b's, by the scans of the stretch
};

/// Which pairs are taken.
struct PairParams {
  /// Errors differ by this at the least: closer pairs tell nothing.
  double least_m = 0.1;
  /// Weights are of the scans of the last metres of the path. Scans of one place repeat each other,
  /// so what a stretch tells is less than its scans one by one; 10 m is about what lies between two
  /// resamplings. 0: of the last scan alone.
  double stretch_m = 10;
};

/// The pairs of all updates of a drive, as the filter weighed them before any resampling, with the
/// factors for new ground and revisits taken out. Resampling leaves out who was voted out within
/// the stretch.
///
/// How far a particle is off: the distance of its pose from the true one, both seen from where the
/// robot was when it last passed here (the map that the scan is held against was drawn there), on
/// new ground from the start of the path.
/// Same bits for the same arguments. Throws core::UsageError where [filter] new_ground_weight is 0.
std::vector<WeightPair> weightPairs(const sim::SimulatedDrive& seen, const slam::SlamParams& params,
                                    std::uint64_t seed, const PairParams& which);

}  // namespace ariadne::experiment
