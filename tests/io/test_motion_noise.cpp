#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/io/motion_noise.h"

using ariadne::io::MotionNoise;
using ariadne::io::NoisyOdometry;
using mrpt::math::TPose2D;

namespace {

struct Spread {
  double x = 0, y = 0, phi = 0;
};

/// Standard deviations of `count` noisy increments of the same motion. With 4000 draws a sample
/// deviation is within 5 % of the true one in 4.5 sigma.
Spread spread(const MotionNoise& noise, const TPose2D& motion, int count = 4000) {
  NoisyOdometry odometry(noise, 5);
  TPose2D clean, before = odometry.add(clean);
  Spread sum;
  for (int i = 0; i < count; ++i) {
    clean = clean + motion;
    const TPose2D noisy = odometry.add(clean);
    const TPose2D step = noisy - before;
    before = noisy;
    sum.x += std::pow(step.x - motion.x, 2);
    sum.y += std::pow(step.y - motion.y, 2);
    sum.phi += std::pow(std::remainder(step.phi - motion.phi, 2 * M_PI), 2);
  }
  return {std::sqrt(sum.x / count), std::sqrt(sum.y / count), std::sqrt(sum.phi / count)};
}

}  // namespace

TEST(MotionNoise, SpreadsAsItSays) {
  const Spread s = spread({0.1, 0.02, 0.05, 0.03}, {0.3, 0.4, -0.6});
  EXPECT_NEAR(s.phi / (0.1 * 0.6 + 0.02 * 0.5), 1, 0.05);
  EXPECT_NEAR(s.x / (0.05 * 0.5 + 0.03 * 0.6), 1, 0.05);
  EXPECT_NEAR(s.y / (0.05 * 0.5 + 0.03 * 0.6), 1, 0.05);
}

TEST(MotionNoise, ATurnInPlaceWithACentimetreOfTravelStaysSane) {
  const Spread s = spread({0.1, 0, 0.1, 0}, {0, 0.01, 0.05});
  EXPECT_NEAR(s.phi / 0.005, 1, 0.05);
  EXPECT_NEAR(s.x / 0.001, 1, 0.05);
}

TEST(MotionNoise, StandingStillAddsNothing) {
  const Spread s = spread({1, 1, 1, 1}, {0, 0, 0}, 10);
  EXPECT_EQ(s.x + s.y + s.phi, 0);
}

TEST(MotionNoise, SameSeedSameNoise) {
  NoisyOdometry a({}, 1), b({}, 1), c({}, 2);
  TPose2D last_a, last_b, last_c;
  for (int i = 0; i < 20; ++i) {
    const TPose2D clean(0.1 * i, 0, 0.05 * i);
    last_a = a.add(clean);
    last_b = b.add(clean);
    last_c = c.add(clean);
  }
  EXPECT_EQ(last_a.x, last_b.x);
  EXPECT_EQ(last_a.phi, last_b.phi);
  EXPECT_NE(last_a.x, last_c.x);
}

TEST(MotionNoise, BoundsAreChecked) {
  EXPECT_NO_THROW(ariadne::io::validate({0, 0, 0, 0}));
  EXPECT_THROW(ariadne::io::validate({-1, 0, 0, 0}), ariadne::core::UsageError);
  EXPECT_THROW(ariadne::io::validate({0, 0, 0, std::nan("")}), ariadne::core::UsageError);
}
