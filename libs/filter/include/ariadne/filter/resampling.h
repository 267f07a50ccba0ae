// Which particles live on. MRPT's methods, but for the residual one: MRPT 2.5.8's own draws its
// residual part from the smallest of N uniform numbers (CParticleFilterCapable.cpp), which prefers
// low indices: with ten particles one that should have 2.6 children gets 3.4.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/filter/params.h"

namespace ariadne::filter {

/// As many indices as there are particles, ascending; index i is drawn about N w_i times.
/// @param log_weights of all N particles, up to a constant
std::vector<std::size_t> drawByWeight(Resampling method, const std::vector<double>& log_weights,
                                      core::RandomStream& rng);

/// Index i floor(N w_i) times, the rest drawn by the remainders; ascending.
/// @param weights normalised, N of them
std::vector<std::size_t> residualIndices(const std::vector<double>& weights,
                                         core::RandomStream& rng);

}  // namespace ariadne::filter
