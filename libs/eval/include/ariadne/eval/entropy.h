// Entropy of the filter's posterior, Eq. (6) of the paper:
//   H(p(m, x | d)) = H(p(x | d)) + sum over s of w_s H(p(m | x_s, d)).
// The first term is a differential entropy (of m, m, rad) and may be negative; only differences
// between sets with the same floor mean something.
#pragma once
#include <vector>

#include "ariadne/eval/map_entropy.h"
#include "ariadne/eval/pose_entropy.h"
#include "ariadne/filter/particle.h"

namespace ariadne::eval {

struct Entropy {
  double pose = 0;  ///< of the current poses: Gaussian fit, nats
  double path = 0;  ///< mean over the poses of the path, nats: H(x_1:t | d) / t, roughly
  double map = 0;   ///< mean of the maps' entropies by weight, nats

  /// Eq. (6) with the Gaussian fit of the current poses as the first term.
  double totalByPose() const { return pose + map; }
  /// Eq. (6) with the average over the path as the first term.
  double totalByPath() const { return path + map; }
};

/// @param particles not null, each with an ancestor, their maps with one resolution and origin
/// @param weights normalised, one a particle
/// @param cells which cells of the maps count
/// Throws core::Error for weights that are not normalised or not one a particle.
Entropy entropyOf(const std::vector<const filter::Particle*>& particles,
                  const std::vector<double>& weights, const CountedCells& cells = {},
                  const EntropyFloor& floor = {});

}  // namespace ariadne::eval
