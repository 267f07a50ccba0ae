// What one filter update did: returned by value, fetched by nobody.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <cstddef>

#include "ariadne/loops/closing/loop_closer.h"

namespace ariadne::slam {

/// What one filter update did: a row of steps.csv.
struct StepReport {
  std::size_t step = 0;  ///< number of the filter update, from 0
  double time_s = 0;     ///< UNIX time of the scan
  double neff = 0;       ///< Eq. (10), after weighing and before resampling
  bool resampled = false;
  std::size_t particles = 0;
  std::size_t matches_accepted = 0;  ///< particles whose match beat the predicted pose
  double log_likelihood = 0;  ///< weighted mean, untempered, of the scan in the particles' maps
  std::size_t best = 0;       ///< index of s*, Eq. (8)
  mrpt::math::TPose2D map_from_robot;  ///< pose of s*

  loops::LoopReport loops;
};

}  // namespace ariadne::slam
