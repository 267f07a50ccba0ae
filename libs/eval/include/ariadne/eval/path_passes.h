// How often a path had been at each of its points before: which stretches are new and which are
// driven again.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/geometry/trajectory.h"

namespace ariadne::eval {

/// When a path counts as being at a point again.
struct PassParams {
  double near_m = 1;     ///< the path is at a point again when it comes nearer than this
  double apart_m = 20;   ///< with more path than this between two passes
  double every_m = 0.1;  ///< the path is looked at each so far
};

/// A point of the path.
struct PathPoint {
  double time_s = 0;
  double travelled_m = 0;  ///< path since its start
  std::size_t passes = 0;  ///< times it was here before
};

/// Points along the path, straight between its poses. Quadratic in their number.
/// @param path in time order. Throws core::UsageError for none, or parameters that are not
/// positive.
std::vector<PathPoint> pathPasses(const geometry::Trajectory& path, const PassParams& params = {});

/// The point nearest in time. `points` must not be empty.
const PathPoint& pointAt(const std::vector<PathPoint>& points, double time_s);

}  // namespace ariadne::eval
