#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/models/proposal.h"
#include "room.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

struct Fixture {
  Fixture() : points(grid::scanPoints(*test::scanIn(test::roomWorld(), truth), 30)) {}
  models::PoseGaussian fit(const models::Gains& gains, const TPose2D& predicted) const {
    const Eigen::Matrix3d prior = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
    return models::fitProposal(likelihood, map, points, truth, {predicted, prior}, gains);
  }
  TPose2D truth{0.2, 0.1, 0.3};
  grid::OccupancyGrid map = test::roomMap();
  grid::EndpointLikelihood likelihood{{}, grid::GridParams().field_sigma_m};
  std::vector<mrpt::math::TPoint2D> points;
};

}  // namespace

TEST(Proposal, IsNarrowerThanThePriorAndNarrowsWithTheGain) {
  const Fixture f;
  const auto wide = f.fit({1, 0.05}, f.truth);
  const auto narrow = f.fit({16, 0.05}, f.truth);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(wide.covariance(i, i), 0.01);
    EXPECT_LT(narrow.covariance(i, i), wide.covariance(i, i));
  }
}

// N = 5000: the standard error of a variance is 2 % of it; the bound is 5 of them.
TEST(Proposal, SamplesHaveItsCovariance) {
  const auto fit = Fixture().fit({8, 0.05}, {0.2, 0.1, 0.3});
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const int n = 5000;
  for (int i = 0; i < n; ++i) {
    core::RandomStream rng(4, 0, static_cast<std::uint32_t>(i), core::Purpose::proposal);
    const TPose2D s = fit.sample(rng);
    const Eigen::Vector3d d(s.x - fit.mean.x, s.y - fit.mean.y, s.phi - fit.mean.phi);
    sum += d * d.transpose();
  }
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(sum(i, i) / n, fit.covariance(i, i), 0.1 * fit.covariance(i, i));
}

// With the scan tempered away the weight is the integral of the prior: 1.
TEST(Proposal, TheNormaliserOfThePriorAloneIsOne) {
  const Fixture f;
  EXPECT_NEAR(f.fit({8, 1e-12}, f.truth).log_weight, 0, 1e-6);
}

// Laplace's integral is exact for a Gaussian likelihood: with gains equal and mode = prior mean it
// is l - log det(Q (Q^-1 + g H)) / 2.
TEST(Proposal, TheNormaliserIsThatOfGaussians) {
  const Fixture f;
  const auto fit = f.fit({0.5, 0.5}, f.truth);
  const Eigen::Matrix3d prior = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
  const double expected =
      0.5 * fit.log_likelihood + 0.5 * std::log((fit.covariance * prior.inverse()).determinant());
  EXPECT_NEAR(fit.log_weight, expected, 1e-9);
}

TEST(Proposal, APriorThatDisagreesWeighsLess) {
  const Fixture f;
  EXPECT_GT(f.fit({8, 0.05}, f.truth).log_weight, f.fit({8, 0.05}, {0.4, 0.1, 0.3}).log_weight);
}
