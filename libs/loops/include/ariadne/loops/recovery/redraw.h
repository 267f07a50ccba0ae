// Present hypotheses whose path since an entry point was drawn anew, given the loop's closure.
#pragma once
#include <vector>

#include "ariadne/loops/recovery/recover.h"

namespace ariadne::loops {

/// The particles with these lines, their maps and graphs made anew since te.
/// @param present saved from the present set as of te, one entry per particle
/// @param leaves of the new lines, which descend from the entries' nodes at te; null leaves a
/// particle
///   as it is
/// @param particles and graphs of the present set, one per entry
RecoveredSet redraw(const SavedSet& present, const std::vector<filter::AncestorPtr>& leaves,
                    const filter::ParticleSet& particles, const std::vector<PlaceGraph>& graphs,
                    const RecoveryInputs& inputs);

}  // namespace ariadne::loops
