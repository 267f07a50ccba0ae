#include "recapture.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"
#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/models/scan_matcher.h"

namespace ariadne::slam {
namespace {

using mrpt::DEG2RAD;
using mrpt::math::TPose2D;

/// Mean field under a scan's endpoints from which on it is known where it was taken. Of an endpoint
/// the field is spread by up to 0.5, and the best of all the places in a window lies about two
/// deviations of the mean above what chance gives: of few endpoints more is asked.
double leastScore(std::size_t points) { return 0.5 + 1 / std::sqrt(static_cast<double>(points)); }

/// Half widths of a search about a pose.
struct Window {
  double distance_m;
  double angle_deg;
};

Eigen::Matrix3d diagonal(double distance_m, double angle_rad) {
  return Eigen::Vector3d(distance_m, distance_m, angle_rad).cwiseAbs2().asDiagonal();
}

/// Found, the motion is known as well as the filter's own matching starts from; a guess is kept.
const Eigen::Matrix3d kKnown = diagonal(0.1, DEG2RAD(3.0));
const Eigen::Matrix3d kKept = diagonal(1e-3, 1e-4);

/// The windows to try in turn, the nearest first: the more there is to choose from, the more looks
/// alike.
std::vector<Window> windowsFor(const Doubt& doubt) {
  std::vector<Window> windows;
  if (doubt.blind) {
    const double distance_m = 3 * std::sqrt(doubt.covariance.topLeftCorner<2, 2>().trace() / 2);
    const double angle_deg = 3 * mrpt::RAD2DEG(std::sqrt(doubt.covariance(2, 2)));
    windows.push_back({std::clamp(distance_m, 0.3, 1.0), std::clamp(angle_deg, 6.0, 20.0)});
  }
  if (doubt.claimed) {
    windows.push_back({0.6, 30});
    windows.push_back({3, 180});
  }
  return windows;
}

}  // namespace

Recaptured Recapture::operator()(const filter::Particle& particle,
                                 const std::vector<mrpt::math::TPoint2D>& points,
                                 const TPose2D& expected, const Doubt& doubt) const {
  const double found = leastScore(points.size());
  const auto lookAbout = [&](const TPose2D& motion, const Window& window) {
    models::MatcherParams wide = params_;
    wide.search_distance_m = window.distance_m;
    wide.search_angle_deg = window.angle_deg;
    wide.sweep_below = wide.search_below = 1;
    const Eigen::Matrix3d prior = diagonal(window.distance_m / 2, DEG2RAD(window.angle_deg / 2));
    return models::ScanMatcher(wide, gain_)(
        particle.map, points, geometry::compose(particle.map_from_robot, motion), prior);
  };
  const auto motionTo = [&](const models::Match& match) {
    return geometry::relativePose(particle.map_from_robot, match.map_from_robot);
  };
  for (const Window& window : windowsFor(doubt)) {
    const models::Match match = lookAbout(expected, window);
    if (match.score >= found) return {motionTo(match), kKnown, Recaptured::By::scan};
  }
  if (!doubt.claimed) return {expected, kKept, Recaptured::By::odometry};
  const models::Match match = lookAbout(*doubt.claimed, {0.3, 12});
  if (match.score >= found) return {motionTo(match), kKnown, Recaptured::By::odometry};
  // Neither is sure: the robot is taken to be where the scan lies better.
  const bool rather_there = match.score > lookAbout(expected, {0.3, 12}).score;
  return {rather_there ? motionTo(match) : expected, kKept, Recaptured::By::guess};
}

}  // namespace ariadne::slam
