// Errors of a trajectory: absolute (ATE) and relative (RPE), after Sturm et al., "A benchmark for
// the evaluation of RGB-D SLAM systems", IROS 2012, in the plane.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/eval/alignment.h"

namespace ariadne::eval {

/// Figures of a list of errors; all 0 for an empty one.
struct ErrorFigures {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;  ///< standard deviation about the mean
  double rmse = 0;
  double median = 0;
  double max = 0;
};

/// RMSE, mean, standard deviation, median and largest of the errors; zeros of none.
ErrorFigures figuresOf(std::vector<double> errors);

/// Distance of each aligned estimate from the truth, m, in the pairs' order.
std::vector<double> absoluteErrors(const std::vector<PosePair>& pairs,
                                   const mrpt::math::TPose2D& truth_from_estimate);

/// Errors of relative poses (Sturm et al., IROS 2012), one of each per pair.
struct RelativeErrors {
  std::vector<double> translation_m;
  std::vector<double> rotation_deg;
};

/// For each pair and the first one at least `delta_m` of true travel later: the length and the turn
/// of (estimated motion)^-1 (true motion).
RelativeErrors relativeErrors(const std::vector<PosePair>& pairs, double delta_m);

}  // namespace ariadne::eval
