#include "agreement.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ariadne/geometry/axes.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::loops {
namespace {

using mrpt::math::TPoint2D;

/// Direction across the wall at a beam's end, from the ends about it: two neighbours alone are
/// nearer to each other than the laser's noise allows, and a bare wall would hold along itself.
std::optional<Eigen::Vector2d> normalAt(const ScanHits& hits, std::size_t i) {
  constexpr double kNear_m = 0.6;
  constexpr std::size_t kNeighbours = 5;  // to each side
  constexpr std::size_t kFewest = 4;
  constexpr double kThin = 0.05;  // variance across the wall to that along it
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  std::size_t n = 0;
  for (std::size_t k = i - std::min(i, kNeighbours); k < std::min(hits.size(), i + kNeighbours + 1);
       ++k) {
    const Eigen::Vector2d d(hits[k].x - hits[i].x, hits[k].y - hits[i].y);
    if (d.norm() > kNear_m) continue;
    sum += d;
    squares += d * d.transpose();
    ++n;
  }
  if (n < kFewest) return std::nullopt;
  const Eigen::Matrix2d spread = squares - sum * sum.transpose() / static_cast<double>(n);
  const geometry::Axes axes = geometry::axesOf(spread);
  if (axes.values[0] > kThin * axes.values[1]) return std::nullopt;
  return axes.vectors.col(0);
}

/// What holds across walls of each direction: of all ends of a scan, and of those that agree.
struct Held {
  Eigen::Matrix2d all = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d agreeing = Eigen::Matrix2d::Zero();
};

/// Takes the information out along each axis in which too few of the walls agree: two places of
/// one corridor agree in its walls, and a door here and there does so by chance.
void dropUnsupported(const Held& held, double least_share, Eigen::Matrix3d& information) {
  const geometry::Axes axes = geometry::axesOf(held.all);
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d axis = axes.vectors.col(k);
    if (axis.dot(held.agreeing * axis) >= least_share * axes.values[k]) continue;
    Eigen::Matrix3d keep = Eigen::Matrix3d::Identity();
    keep.topLeftCorner<2, 2>() -= axis * axis.transpose();
    information = keep * information * keep;
  }
}

/// Index of the end of `wall` that is nearest to the point and within the tolerance; its size when
/// none is.
std::size_t nearestEnd(const ScanHits& wall, const TPoint2D& p, double tolerance_m) {
  double nearest = tolerance_m * tolerance_m;
  std::size_t at = wall.size();
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const double d = (wall[i].x - p.x) * (wall[i].x - p.x) + (wall[i].y - p.y) * (wall[i].y - p.y);
    if (d < nearest) {
      nearest = d;
      at = i;
    }
  }
  return at;
}

}  // namespace

double agreement(const ScanHits& wall, const ScanHits& scan, const mrpt::math::TPose2D& pose,
                 const ContactParams& params, Eigen::Matrix3d& information) {
  // Ends of one beam are worth a tenth of what they say: they share the map's and the pose's
  // errors.
  constexpr double kEndInformation = 0.1 / (0.05 * 0.05);
  std::size_t agree = 0;
  Held held;
  Eigen::Matrix3d known = Eigen::Matrix3d::Zero();
  const ScanHits ends = geometry::placed(pose, scan);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const auto across = normalAt(ends, k);
    if (across) held.all += *across * across->transpose();
    const TPoint2D& p = ends[k];
    const std::size_t at = nearestEnd(wall, p, params.tolerance_m);
    if (at == wall.size()) continue;
    ++agree;
    if (across) held.agreeing += *across * across->transpose();
    const auto normal = normalAt(wall, at);
    if (!normal) continue;
    // A shift (x, y) and turn of the second robot moves its beams' ends across the wall by this.
    const double nx = (*normal)[0], ny = (*normal)[1];
    const Eigen::Vector3d j(nx, ny, -nx * (p.y - pose.y) + ny * (p.x - pose.x));
    known += kEndInformation * j * j.transpose();
  }
  dropUnsupported(held, params.least_share, known);
  information += known;
  return scan.empty() ? 0 : static_cast<double>(agree) / static_cast<double>(scan.size());
}

}  // namespace ariadne::loops
