// Aligns a scan to a particle's own map: Gauss-Newton on the likelihood field about the predicted
// pose, with the motion model as prior. After Kohlbrecher et al., "A flexible and scalable SLAM
// system with full 3D motion estimation", SSRR 2011, Eq. (7)-(13).
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/models/params.h"

namespace ariadne::models {

/// Where a scan fits a map, and how well.
struct Match {
  mrpt::math::TPose2D map_from_robot;  ///< best pose found; the predicted one when not accepted
  bool accepted = false;               ///< it beats the predicted pose
  double score = 0;                    ///< mean field under the endpoints, 0..1
};

/// Finds the pose near a predicted one at which a scan fits a map best, by ascent in the likelihood
/// field.
class ScanMatcher {
 public:
  /// @param gain weight of the scan against the prior, as the filter's proposal_gain.
  ScanMatcher(const MatcherParams& params, double gain) : params_(params), gain_(gain) {}

  /// @param points ends of beams, m, robot's frame
  /// @param predicted mean of the motion model, map frame
  /// @param prior covariance of the motion model, (x, y, heading), map frame
  Match operator()(const grid::OccupancyGrid& map, const std::vector<mrpt::math::TPoint2D>& points,
                   const mrpt::math::TPose2D& predicted, const Eigen::Matrix3d& prior) const;

 private:
  struct Scratch;
  struct Problem;
  struct Candidate;
  Candidate climb(const Problem& problem, Candidate from) const;
  mrpt::math::TPose2D search(const Problem& problem, double distance_m) const;

  MatcherParams params_;
  double gain_;
};

}  // namespace ariadne::models
