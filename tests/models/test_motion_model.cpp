#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/geometry/covariance.h"
#include "ariadne/models/motion_model.h"

using namespace ariadne;
using mrpt::math::TPose2D;

// N = 20000: the standard error of a variance is 1 % of it; the bound is 5 of them.
TEST(Motion, SamplesHaveTheStatedCovariance) {
  const TPose2D before(3, 1, 0.7);
  const models::Motion motion({0.5, 0.1, 0.3}, models::MotionParams());
  const TPose2D mean = motion.mean(before);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    core::RandomStream rng(1, 0, static_cast<std::uint32_t>(i), core::Purpose::motion);
    const TPose2D s = motion.sample(before, rng);
    const Eigen::Vector3d d(s.x - mean.x, s.y - mean.y, s.phi - mean.phi);
    sum += d * d.transpose();
  }
  const Eigen::Matrix3d expected = motion.covariance(before);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(sum(i, j) / n, expected(i, j), 0.05 * std::sqrt(expected(i, i) * expected(j, j)));
}

// Rotation-translation-rotation would see two turns of 90 degrees here, and noise for both.
TEST(Motion, ACentimetreSidewaysIsNoTurn) {
  const models::MotionParams params;
  const models::Motion sideways({0, 0.01, 0.02}, params);
  EXPECT_LT(std::sqrt(sideways.covariance({})(2, 2)), 0.02);
}

TEST(Motion, NoiseGrowsWithDistanceAndTurn) {
  const auto spread = [](double x, double turn) {
    return models::Motion({x, 0, turn}, models::MotionParams()).covariance({}).diagonal().eval();
  };
  EXPECT_GT(spread(1, 0)[0], spread(0.5, 0)[0]);
  EXPECT_GT(spread(1, 0)[2], spread(0.5, 0)[2]);
  EXPECT_GT(spread(0.5, 0.5)[2], spread(0.5, 0.2)[2]);
}

TEST(Motion, CovarianceTurnsWithTheRobot) {
  const models::Motion motion({1, 0, 0}, models::MotionParams());
  const auto ahead = motion.covariance({0, 0, 0});
  const auto turned = motion.covariance({0, 0, M_PI / 2});
  EXPECT_NEAR(ahead(0, 0), turned(1, 1), 1e-12);
  EXPECT_NEAR(ahead(1, 1), turned(0, 0), 1e-12);
}

namespace {

/// Sample covariance of `draw(i)` about `mean`.
template <class Draw>
Eigen::Matrix3d sampleCovariance(int n, const TPose2D& mean, Draw&& draw) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 0; i < n; ++i) {
    const TPose2D s = draw(i);
    const Eigen::Vector3d d(s.x - mean.x, s.y - mean.y, std::remainder(s.phi - mean.phi, 2 * M_PI));
    sum += d * d.transpose();
  }
  return sum / n;
}

void expectAlike(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b, double share) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(a(i, j), b(i, j), share * std::sqrt(b(i, i) * b(j, j))) << i << j;
}

core::RandomStream streamOf(int i, std::uint32_t what) {
  return {1, what, static_cast<std::uint32_t>(i), core::Purpose::motion};
}

}  // namespace

TEST(Motion, TakesAGivenCovariance) {
  Eigen::Matrix3d given;
  given << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.01;
  const models::Motion motion({0.5, 0.1, 0.3}, given);
  expectAlike(motion.covariance({0, 0, 0}), given, 1e-12);
  const TPose2D before(3, 1, 0.7);
  const auto drawn = sampleCovariance(20000, motion.mean(before), [&](int i) {
    auto rng = streamOf(i, 0);
    return motion.sample(before, rng);
  });
  expectAlike(drawn, motion.covariance(before), 0.05);
}

// Against samples of one motion behind the other. To first order: the noise is small, and the bound
// is that of the sampling as above.
TEST(Motion, ComposedCovarianceIsThatOfBoth) {
  const models::MotionParams params;
  const models::Motion first({0.3, 0.1, 0.2}, params), second({0.4, 0, -0.1}, params);
  const TPose2D start(0, 0, 0), between = first.mean(start);
  const auto expected = geometry::composedCovariance(between, first.covariance(start),
                                                     {0.4, 0, -0.1}, second.covariance(start));
  const auto drawn = sampleCovariance(20000, second.mean(between), [&](int i) {
    auto rng = streamOf(i, 1);
    auto other = streamOf(i, 2);
    return second.sample(first.sample(start, rng), other);
  });
  expectAlike(drawn, expected, 0.05);
}
