#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/statistics/logistic.h"

using ariadne::statistics::logisticSlope;

TEST(LogisticSlope, OfFewPairsInClosedForm) {
  // Three of four right at the same ratio: 1 / (1 + exp(-2 k)) = 3/4.
  EXPECT_NEAR(logisticSlope({2, 2, 2, -2}), std::log(3) / 2, 1e-9);
  EXPECT_NEAR(logisticSlope({2, -2}), 0, 1e-9);
  EXPECT_NEAR(logisticSlope({-5, -5, 5}), -std::log(2) / 5, 1e-9);
}

TEST(LogisticSlope, OfNothingOrOneSide) {
  EXPECT_EQ(logisticSlope({}), 0);
  EXPECT_EQ(logisticSlope({0, 0}), 0);
  EXPECT_EQ(logisticSlope({1, 3, 0}), INFINITY);
  EXPECT_EQ(logisticSlope({-1, -3}), -INFINITY);
}

TEST(LogisticSlope, IsWhatThePairsWereDrawnWith) {
  for (const double k : {0.02, 0.4, 1.0, 2.5}) {
    ariadne::core::RandomStream rng(7, 0, 0, ariadne::core::Purpose::motion);
    std::vector<double> pairs;
    for (int i = 0; i < 20000; ++i) {
      const double x = 3 * rng.gaussian();
      pairs.push_back(rng.uniform() < 1 / (1 + std::exp(-k * x)) ? x : -x);
    }
    // Four standard errors: 1 / sqrt(n E[x^2 p (1 - p)]), at most 0.034 for these slopes.
    double information = 0;
    for (const double x : pairs) {
      const double p = 1 / (1 + std::exp(-k * x));
      information += x * x * p * (1 - p);
    }
    EXPECT_NEAR(logisticSlope(pairs), k, 4 / std::sqrt(information)) << k;
  }
}

TEST(LogisticSlope, OfLargeRatiosIsFinite) {
  EXPECT_NEAR(logisticSlope({1e6, 1e6, 1e6, -1e6}), std::log(3) / 1e6, 1e-12);
  EXPECT_NEAR(logisticSlope({1e-6, 1e-6, 1e-6, -1e-6}), std::log(3) / 1e-6, 1);
}
