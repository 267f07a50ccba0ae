// Propagating the saved hypotheses through the loop, Eq. (13).
#pragma once
#include <cstdint>
#include <vector>

#include "ariadne/core/parallel.h"
#include "ariadne/recovery/params.h"
#include "ariadne/recovery/saved_set.h"

namespace ariadne::recovery {

/// What recovery works with besides the two sets of particles.
struct RecoveryInputs {
  const std::vector<grid::ScanShape>& shapes;  ///< scans of all updates, by number
  std::size_t checkpoint_updates = 20;
  std::uint64_t seed = 1;
  const core::Parallel& parallel;
};

struct RecoveredSet {
  std::vector<filter::Particle> particles;  ///< one an entry
  std::vector<double> weights;              ///< w~; sum 1
  std::vector<topology::PlaceGraph> graphs;
  std::vector<std::size_t> sources;   ///< index of the present particle whose way each one took
  std::vector<double> contradiction;  ///< share of the way's beams that end in what was free at te
};

/// @param graphs of the present particles, one each
RecoveredSet recover(const SavedSet& saved, const filter::ParticleSet& present,
                     const std::vector<topology::PlaceGraph>& graphs, const RecoveryInputs& inputs,
                     Draw draw);

}  // namespace ariadne::recovery
