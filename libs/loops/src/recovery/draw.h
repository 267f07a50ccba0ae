// Importance sampling of paths through the loop from p(x_te+1:t | x_1:te, z, u), section V.
#pragma once
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/filter/particle_set.h"
#include "ariadne/loops/recovery/params.h"
#include "ariadne/loops/recovery/saved_set.h"

namespace ariadne::loops {

/// Index of the present particle whose path each saved entry gets.
std::vector<std::size_t> drawSources(const SavedSet& saved, const filter::ParticleSet& present,
                                     Draw draw, std::uint64_t seed);

}  // namespace ariadne::loops
