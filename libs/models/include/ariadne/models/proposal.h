// The improved proposal: a Gaussian fitted to p(z | x, m) p(x | x', u) about the matched pose, and
// its integral, the particle's weight. After Grisetti, Stachniss, Burgard, "Improved techniques for
// grid mapping with Rao-Blackwellized particle filters", T-RO 2007, Eq. (12)-(19); the width is
// from the Fisher information of the scan instead of samples about the mode.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/grid/field/endpoint_likelihood.h"

namespace ariadne::models {

/// Two gains temper the scan's log likelihood: one for the width of the proposal, one for the
/// weight. A low first samples drift into every map; a high second leaves one hypothesis.
struct Gains {
  double proposal;
  double weight;
};

/// The gain at which (Q^-1 + gain H)^-1, Q of the motion and H of the scan, is how far a matched
/// step is truly off (doc/lab/benchmarks/large-loops.md, "How far steps are off").
constexpr double kCalibratedGain = 0.3;

/// p(x | x', u) as a Gaussian: mean (map frame) and covariance of (x, y, heading).
struct PosePrior {
  mrpt::math::TPose2D mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// A Gaussian over poses.
struct PoseGaussian {
  mrpt::math::TPose2D mean;     ///< map frame
  Eigen::Matrix3d covariance;   ///< of (x, y, heading)
  double log_weight = 0;        ///< log of the integral of likelihood^weight_gain times prior
  double log_likelihood = 0;    ///< untempered, at the mean
  Eigen::Matrix3d information;  ///< of the scan about the pose, untempered

  /// Map frame.
  mrpt::math::TPose2D sample(core::RandomStream& rng) const;
};

/// @param mode pose that maximises likelihood times prior, from the scan matcher.
/// @param told projects (x, y, heading), map frame, onto what the scan tells of: the identity where
/// it tells of all
PoseGaussian fitProposal(const grid::EndpointLikelihood& likelihood, const grid::OccupancyGrid& map,
                         const std::vector<mrpt::math::TPoint2D>& points,
                         const mrpt::math::TPose2D& mode, const PosePrior& prior,
                         const Gains& gains,
                         const Eigen::Matrix3d& told = Eigen::Matrix3d::Identity());

}  // namespace ariadne::models
