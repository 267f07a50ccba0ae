// The particles at the entry of a loop as the present ones remember them, Eq. (11) and (12).
#pragma once
#include <memory>
#include <vector>

#include "ariadne/filter/particle_set.h"
#include "ariadne/loops/places/place_graph.h"

namespace ariadne::loops {

/// One saved hypothesis of Eq. (11) and (12).
struct SavedEntry {
  filter::AncestorPtr at_te;      ///< x~, Eq. (11): the ancestor at te, with the trajectory before
  filter::AncestorPtr at_saving;  ///< the particle's own node when it was saved
  std::shared_ptr<const filter::Checkpoint> checkpoint;  ///< latest map at or before te
  double weight = 0;                                     ///< w~, Eq. (12); they sum to 1
  PlaceGraph graph;                                      ///< G as of te
};

/// The hypotheses that were kept at a detection.
struct SavedSet {
  std::size_t te = 0;      ///< filter update of the entry
  std::size_t saving = 0;  ///< filter update at which it was saved
  std::vector<SavedEntry> entries;

  /// Distinct ancestors at te: hypotheses that are still there.
  std::size_t distinctAncestors() const;
  /// Memory of all tiles of the saved maps, each counted once, bytes; they may be shared with the
  /// live set.
  std::size_t mapBytes() const;
};

/// @param graphs one per particle
/// @param te a past update; throws std::out_of_range when it is not
SavedSet save(const filter::ParticleSet& particles, const std::vector<PlaceGraph>& graphs,
              std::size_t te);

}  // namespace ariadne::loops
