// Distances in the plane, m.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <cmath>

namespace ariadne::explore {

inline double distance(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

inline double distance(const mrpt::math::TPoint2D& p, const mrpt::math::TPose2D& robot) {
  return std::hypot(p.x - robot.x, p.y - robot.y);
}

}  // namespace ariadne::explore
