#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/eval/exact_tests.h"
#include "ariadne/eval/interval.h"
#include "ariadne/eval/plan.h"

using namespace ariadne;

// Newcombe, Statistics in Medicine 17 (1998), table I, method 3.
TEST(Wilson, IsThatOfNewcombe) {
  const struct {
    std::size_t r, n;
    double low, high;
  } cases[] = {{81, 263, 0.2553, 0.3662},
               {15, 148, 0.0624, 0.1605},
               {0, 20, 0, 0.1611},
               {1, 29, 0.0061, 0.1718}};
  for (const auto& c : cases) {
    const auto i = eval::wilsonInterval(c.r, c.n);
    EXPECT_NEAR(i.low, c.low, 5e-5);
    EXPECT_NEAR(i.high, c.high, 5e-5);
  }
  EXPECT_THROW(eval::wilsonInterval(1, 0), core::Error);
}

TEST(McNemar, IsTheBinomialTest) {
  // 2 P(X <= 1), X ~ Bin(10, 1/2) = 2 (1 + 10) / 1024.
  EXPECT_NEAR(eval::mcnemarTest(1, 9), 22.0 / 1024, 1e-12);
  EXPECT_NEAR(eval::mcnemarTest(9, 1), 22.0 / 1024, 1e-12);
  EXPECT_EQ(eval::mcnemarTest(4, 4), 1);
  EXPECT_EQ(eval::mcnemarTest(0, 0), 1);
}

// The lady tasting tea: Agresti, Categorical Data Analysis (2002), 3.5.2: two-sided 0.486.
TEST(Fisher, IsTheLadysTea) { EXPECT_NEAR(eval::fisherTest(3, 4, 1, 4), 34.0 / 70, 1e-9); }

TEST(Holm, StepsDown) {
  const auto p = eval::holmAdjusted({0.01, 0.04, 0.03, 0.005});
  EXPECT_NEAR(p[3], 0.02, 1e-12);
  EXPECT_NEAR(p[0], 0.03, 1e-12);
  EXPECT_NEAR(p[2], 0.06, 1e-12);
  EXPECT_NEAR(p[1], 0.06, 1e-12);
}

TEST(MedianInterval, HoldsTheMedianAndIsReproducible) {
  std::vector<double> values;
  for (int i = 1; i <= 101; ++i) values.push_back(i);
  core::RandomStream a(1, 0, 0, core::Purpose::test);
  core::RandomStream b(1, 0, 0, core::Purpose::test);
  const auto i = eval::medianInterval(values, a);
  const auto j = eval::medianInterval(values, b);
  EXPECT_EQ(i.low, j.low);
  EXPECT_EQ(i.high, j.high);
  // Order statistics about 51 +- 1.96 sqrt(101) / 2.
  EXPECT_NEAR(i.low, 41, 3);
  EXPECT_NEAR(i.high, 61, 3);
}

// n = (1.96 sqrt(2 p q) + 0.8416 sqrt(p1 q1 + p2 q2))^2 / (p1 - p2)^2, p the mean rate (Fleiss,
// Statistical Methods for Rates and Proportions, 1981, (3.14) without its correction).
TEST(Plan, NeedsWhatTheFormulaSaysAndHasTheExactPower) {
  const double mean = (0.4 + 0.93) / 2;
  const double root = 1.959964 * std::sqrt(2 * mean * (1 - mean)) +
                      0.841621 * std::sqrt(0.4 * 0.6 + 0.93 * 0.07);
  EXPECT_NEAR(eval::normalSeeds(0.4, 0.93), root * root / (0.53 * 0.53), 0.01);
  const auto plan = eval::planUnpaired(0.4, 0.93);
  EXPECT_TRUE(plan.exact);
  EXPECT_GE(plan.power, 0.8);
  EXPECT_NEAR(eval::fisherPower(plan.runs, 0.4, plan.runs, 0.93), plan.power, 1e-12);
  EXPECT_LT(eval::fisherPower(plan.runs - 1, 0.4, plan.runs - 1, 0.93), 0.8);
  const auto pairs = eval::planPaired(0.5, 0.02);
  EXPECT_GE(eval::mcnemarPower(pairs.runs, 0.5, 0.02), 0.8);
}
