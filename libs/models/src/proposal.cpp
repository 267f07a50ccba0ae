#include "ariadne/models/proposal.h"

#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::models {
namespace {

using mrpt::math::TPose2D;

TPose2D moved(const TPose2D& pose, const Eigen::Vector3d& by) {
  return geometry::compose({pose.x + by[0], pose.y + by[1], pose.phi + by[2]}, {0, 0, 0});
}

}  // namespace

TPose2D PoseGaussian::sample(core::RandomStream& rng) const {
  const double a = rng.gaussian();
  const double b = rng.gaussian();
  const double c = rng.gaussian();
  const Eigen::Matrix3d root = covariance.llt().matrixL();
  return moved(mean, root * Eigen::Vector3d(a, b, c));
}

PoseGaussian fitProposal(const grid::EndpointLikelihood& likelihood, const grid::OccupancyGrid& map,
                         const std::vector<mrpt::math::TPoint2D>& points, const TPose2D& mode,
                         const PosePrior& prior, const Gains& gains, const Eigen::Matrix3d& told) {
  PoseGaussian fit;
  fit.mean = mode;
  fit.log_likelihood = likelihood(map, points, mode);
  const Eigen::Matrix3d h = told * likelihood.information(map, points, mode) * told;
  fit.information = h;
  const Eigen::Matrix3d prior_information = prior.covariance.inverse();
  fit.covariance = (prior_information + gains.proposal * h).inverse();

  // With log likelihood l(y) = l + g y - y H y / 2 about the mode (y = x - mode) the integral of
  // exp(weight_gain l(y)) N(y; -d, Q) is a Gaussian's; g = Q^-1 d / proposal_gain at the maximum.
  const Eigen::Vector3d d(mode.x - prior.mean.x, mode.y - prior.mean.y,
                          std::remainder(mode.phi - prior.mean.phi, 2 * M_PI));
  const Eigen::Vector3d pull = prior_information * d;
  const Eigen::Matrix3d m = prior_information + gains.weight * h;
  const Eigen::Vector3d b = (gains.weight / gains.proposal - 1) * pull;
  fit.log_weight = gains.weight * fit.log_likelihood - 0.5 * d.dot(pull) +
                   0.5 * b.dot(m.inverse() * b) -
                   0.5 * std::log((prior.covariance * m).determinant());
  return fit;
}

}  // namespace ariadne::models
