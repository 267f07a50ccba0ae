// A closure that was found becomes part of every hypothesis: its path since the anchor is drawn
// given the closure and those that the path holds already.
#pragma once
#include "ariadne/loops/recovery/redraw.h"
#include "ariadne/loops/search/finder.h"

namespace ariadne::loops {

/// @param present saved from the particles as of found.begin
/// @return the new set, with weights by the density of the correction that each needed
RecoveredSet drawGiven(const Closure& found, const Finder& finder, const SavedSet& present,
                       const filter::ParticleSet& particles, const std::vector<PlaceGraph>& graphs,
                       const RecoveryInputs& inputs);

}  // namespace ariadne::loops
