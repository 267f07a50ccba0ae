#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/geometry/axes.h"

using namespace ariadne;

namespace {

void expectEigens(const Eigen::Matrix2d& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigens(m);
  const geometry::Axes ours = geometry::axesOf(m);
  EXPECT_EQ(ours.values, eigens.eigenvalues()) << m;
  EXPECT_EQ(ours.vectors, eigens.eigenvectors()) << m;
}

Eigen::Matrix2d symmetric(double a, double beside, double b) {
  Eigen::Matrix2d m;
  m << a, beside, beside, b;
  return m;
}

}  // namespace

// Runs are compared by their bits.
TEST(Axes, AreEigensToTheBit) {
  core::RandomStream rng(3, 0, 0, core::Purpose::test);
  for (int i = 0; i < 2000; ++i) {
    const double size = std::exp(8 * rng.gaussian());
    expectEigens(symmetric(size * rng.gaussian(), size * rng.gaussian(), size * rng.gaussian()));
  }
}

TEST(Axes, AreEigensWhereTheyAreDegenerate) {
  expectEigens(symmetric(0, 0, 0));
  expectEigens(symmetric(1, 0, 1));
  expectEigens(symmetric(3, 0, 2));
  expectEigens(symmetric(1, 1, 1));
  expectEigens(symmetric(0, -2, 0));
  expectEigens(symmetric(1e-300, 1e-301, 1e-300));
  expectEigens(symmetric(4, 1e-17, 1));
}

TEST(Axes, TheLeastValueIsFirst) {
  const geometry::Axes axes = geometry::axesOf(symmetric(2, 1, 2));
  EXPECT_NEAR(axes.values[0], 1, 1e-12);
  EXPECT_NEAR(axes.values[1], 3, 1e-12);
  EXPECT_NEAR(std::abs(axes.vectors.col(1).sum()), std::sqrt(2.0), 1e-12);
}
