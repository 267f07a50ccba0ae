// Scans for the tests, with ranges drawn from a seed.
#pragma once
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cmath>
#include <functional>

#include "ariadne/core/random.h"

namespace ariadne::test {

/// A scan whose i-th range is range(i); 180 degrees, counterclockwise, maxRange 80 m.
inline mrpt::obs::CObservation2DRangeScan scanOf(std::size_t beams,
                                                 const std::function<double(std::size_t)>& range) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(M_PI);
  scan.rightToLeft = true;
  scan.maxRange = 80;
  scan.resizeScan(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    scan.setScanRange(i, static_cast<float>(range(i)));
    scan.setScanRangeValidity(i, true);
  }
  return scan;
}

/// Piecewise surfaces with edges, as in a cluttered room.
inline mrpt::obs::CObservation2DRangeScan randomScan(std::uint64_t seed, std::size_t beams = 181) {
  core::RandomStream rng(seed, 0, 0, core::Purpose::test);
  double range = 5;
  return scanOf(beams, [&](std::size_t) {
    if (rng.uniform() < 0.1) range = 0.5 + 10 * rng.uniform();
    return range + 0.02 * rng.gaussian();
  });
}

inline mrpt::math::TPose2D randomPose(core::RandomStream& rng, double spread = 3) {
  return {spread * rng.gaussian(), spread * rng.gaussian(), 2 * M_PI * rng.uniform() - M_PI};
}

}  // namespace ariadne::test
