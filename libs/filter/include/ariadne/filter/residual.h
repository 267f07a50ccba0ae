// Residual resampling. MRPT 2.5.8's own draws its residual part from the smallest of N uniform
// numbers (CParticleFilterCapable.cpp), which prefers low indices: with ten particles one that
// should have 2.6 children gets 3.4. Ours stands in for it under the same name.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/core/random.h"

namespace ariadne::filter {

/// Index i floor(N w_i) times, the rest drawn by the remainders; ascending.
/// @param weights normalised, N of them
std::vector<std::size_t> residualIndices(const std::vector<double>& weights,
                                         core::RandomStream& rng);

}  // namespace ariadne::filter
