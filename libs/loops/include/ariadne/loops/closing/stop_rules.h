// When to stop following a loop (section IV), as predicates on the record of the closing so far.
// They hold no state: they run on recorded steps as well as live.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "ariadne/loops/closing/params.h"

namespace ariadne::loops {

/// One filter update within a closing.
struct ClosingStep {
  double travelled_m = 0;  ///< since the start of the run
  double neff = 0;         ///< Eq. (10), before resampling
  double particles = 0;    ///< N
  bool resampled = false;
  double uncertainty_m = 0;  ///< spread of the particles' positions
};

/// What a rule judges.
struct ClosingCourse {
  double loop_length_m = 0;  ///< distance from te to the detection
  double uncertainty_at_te_m = 0;
  std::vector<ClosingStep> steps;  ///< since the entry was reached

  /// Since the closing began, m.
  double driven_m() const {
    return steps.empty() ? 0 : steps.back().travelled_m - steps.front().travelled_m;
  }
};

/// Slope of ln Neff over the path from step `first` on, per metre: the sum of its changes without
/// the rises that resamplings made.
double slopeOfLogNeff(const std::vector<ClosingStep>& steps, std::size_t first);

/// Whether a closing is to end now. Asked after each update of it.
using StopRule = std::function<bool(const ClosingCourse&)>;

/// The paper's: Neff stays constant over the last window_m, to within `change` of N. Resampling
/// sets Neff back to N, which is no information, so a window must not contain one.
StopRule neffConstantFor(double window_m, double change);
/// Fallback: over the last window_m, resamplings apart, ln Neff falls by less than slope_per_m.
StopRule neffFallsLessThan(double slope_per_m, double window_m);
/// [19] of the paper (doc/explanation/bibliography.md): the spread of the particles is back to what
/// it was at te.
StopRule uncertaintyBackToEntry();
/// The loop's length has been driven `laps` times.
StopRule loopDriven(double laps);
/// `rule`, but not before this distance after the entry.
StopRule armedAfter(double distance_m, StopRule rule);
/// The closing goes on until the robot leaves the known places.
StopRule never();

/// The rule that the parameters name; `leaving` has none of its own.
StopRule stopRule(const ClosingParams& params);

}  // namespace ariadne::loops
