// The pose term of Eq. (6): entropy of a Gaussian fitted to weighted poses.
#pragma once
#include <Eigen/Dense>

#include "ariadne/geometry/weighted_poses.h"

namespace ariadne::eval {

/// Standard deviations of the noise that every pose is taken to have; its variances are added to
/// the fitted covariance. So a set of one pose has the noise's entropy instead of minus infinity,
/// and turning the map changes nothing. The defaults, a fifth of a cell and a tenth of a degree,
/// are what the matcher cannot resolve anyway; a single pose then has -11.3 nats.
struct EntropyFloor {
  double position_m = 0.01;
  double heading_deg = 0.1;
};

/// Weighted covariance (divided by the sum of weights, 1) of (x, y, heading), m and rad, about the
/// weighted mean; the heading's mean is the direction of the mean of unit vectors and its residuals
/// are the shorter arcs to it. No floor. Throws as geometry::checkWeightedPoses() does.
Eigen::Matrix3d poseCovariance(const geometry::WeightedPoses& set);

/// ln((2 pi e)^3 det(S + F)) / 2 in nats, S the covariance above and F the floor's.
/// Throws core::Error for a set that is not normalised, core::UsageError for a floor not over 0.
double gaussianEntropy(const geometry::WeightedPoses& set, const EntropyFloor& floor = {});

}  // namespace ariadne::eval
