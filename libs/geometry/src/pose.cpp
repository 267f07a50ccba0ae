#include "ariadne/geometry/pose.h"

namespace ariadne::geometry {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

std::vector<TPoint2D> placed(const TPose2D& pose, const std::vector<TPoint2D>& points) {
  // As TPose2D::composePoint, which would take sine and cosine of each point.
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  std::vector<TPoint2D> out;
  out.reserve(points.size());
  for (const TPoint2D& p : points)
    out.emplace_back(pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y);
  return out;
}

}  // namespace ariadne::geometry
