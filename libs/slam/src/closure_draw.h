// A closure that was found becomes part of every hypothesis: its way since the anchor is drawn
// given the closure and those that the way holds already.
#pragma once
#include "ariadne/closure/finder.h"
#include "ariadne/recovery/redraw.h"

namespace ariadne::slam {

/// @param present saved from the particles as of found.begin
/// @return the new set, with weights by the density of the correction that each needed
recovery::RecoveredSet drawGiven(const closure::Closure& found, const closure::Finder& finder,
                                 const recovery::SavedSet& present,
                                 const filter::ParticleSet& particles,
                                 const std::vector<topology::PlaceGraph>& graphs,
                                 const recovery::RecoveryInputs& inputs);

}  // namespace ariadne::slam
