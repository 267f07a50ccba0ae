// The directions of a scan's beams, out of the little that a CARMEN log says of them.
#pragma once
#include <cstddef>
#include <optional>

namespace ariadne::io {

/// Beam i looks at `start_rad` + i * `step_rad` from the laser's axis; clockwise when the step is
/// negative.
struct CarmenFan {
  double start_rad = 0;
  double step_rad = 0;
};

/// No laser turns further; a turn and a bit, since some drivers repeat the first beam at the end.
constexpr double kWidestFan_deg = 2.1 * 180;
constexpr double kNarrowestFan_deg = 10;

/// Fans about the laser's axis. Of an even number of beams the left end is missing where that makes
/// a round field or step, as with CARMEN: 180 beams of 1 degree look at -90 to 89 degrees.
CarmenFan fanOfField(double field_deg, std::size_t count);
CarmenFan fanOfStep(double step_deg, std::size_t count);

/// Between the first and the last beam, degrees.
double spanOf(const CarmenFan& fan, std::size_t count);
CarmenFan mirrored(const CarmenFan& fan);
/// Whether the fans are as wide as each other within one and a half beams.
bool areAlike(const CarmenFan& a, const CarmenFan& b, std::size_t count);

/// Settings of a SICK that CARMEN's own driver makes, known by their number of beams: 180, 181, 360
/// and 361 are 180 degrees, 100, 101, 200, 201, 400 and 401 are 100. No other number says it: 541
/// or 1081 are 270 degrees with one laser and something else with the next, and 720 or 721 may be
/// 180, 270 or 360.
std::optional<CarmenFan> knownFan(std::size_t count);

}  // namespace ariadne::io
