// Propagating the saved hypotheses through the loop, Eq. (13).
#pragma once
#include <cstdint>
#include <vector>

#include "ariadne/core/parallel.h"
#include "ariadne/loops/recovery/params.h"
#include "ariadne/loops/recovery/saved_set.h"

namespace ariadne::loops {

/// What recovery works with besides the two sets of particles.
struct RecoveryInputs {
  const std::vector<grid::ScanShape>& shapes;  ///< scans of all updates, by number
  std::size_t checkpoint_updates;
  std::uint64_t seed;
  const core::Parallel& parallel;
};

/// What replaces the particle set when a closing ends, Eq. (13).
struct RecoveredSet {
  std::vector<filter::Particle> particles;  ///< one an entry
  std::vector<double> weights;              ///< w~; sum 1
  std::vector<PlaceGraph> graphs;
  std::vector<std::size_t> sources;   ///< index of the present particle whose path each one took
  std::vector<double> contradiction;  ///< share of the path's beams that end in what was free at te
};

/// @param graphs of the present particles, one each
RecoveredSet recover(const SavedSet& saved, const filter::ParticleSet& present,
                     const std::vector<PlaceGraph>& graphs, const RecoveryInputs& inputs,
                     Draw draw);

}  // namespace ariadne::loops
