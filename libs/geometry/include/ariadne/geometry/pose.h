// Poses of the plane: one seen from another, motions in a row, distances. The arithmetic is MRPT's.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <cmath>
#include <vector>

namespace ariadne::geometry {

/// Pose of b seen from a: a^-1 (+) b, heading in (-pi, pi].
inline mrpt::math::TPose2D relativePose(const mrpt::math::TPose2D& a,
                                        const mrpt::math::TPose2D& b) {
  return b - a;
}

/// a (+) b, heading in (-pi, pi].
inline mrpt::math::TPose2D compose(const mrpt::math::TPose2D& a, const mrpt::math::TPose2D& b) {
  return a + b;
}

/// Between two places: anything that has x and y, m.
template <class A, class B>
double distance(const A& a, const B& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Points of the robot's frame as they lie in the frame of `pose`.
std::vector<mrpt::math::TPoint2D> placed(const mrpt::math::TPose2D& pose,
                                         const std::vector<mrpt::math::TPoint2D>& points);

}  // namespace ariadne::geometry
