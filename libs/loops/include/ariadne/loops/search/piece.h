// The last metres of a path with their scans, as one rigid set of points.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/loops/search/track.h"

namespace ariadne::loops {

/// Beams' ends of the updates of the last `length_m`, m, in the frame of the robot at the last
/// update; one point per cell of `spacing_m`, so that what was seen from near weighs no more than
/// what was seen from far; thinned evenly to `most`.
std::vector<mrpt::math::TPoint2D> lastPiece(const Track& track, const std::vector<ScanHits>& hits,
                                            double length_m, double spacing_m, std::size_t most);

}  // namespace ariadne::loops
