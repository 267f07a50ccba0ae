#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/statistics/exact_tests.h"
#include "ariadne/statistics/interval.h"

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
    const auto i = statistics::wilsonInterval(c.r, c.n);
    EXPECT_NEAR(i.low, c.low, 5e-5);
    EXPECT_NEAR(i.high, c.high, 5e-5);
  }
  EXPECT_THROW(statistics::wilsonInterval(1, 0), core::Error);
}

// Fagerland, Lydersen and Laake, BMC Medical Research Methodology 13 (2013), 91: airway
// hyper-responsiveness of 21 children before and after a transplantation, 1 against 7 discordant
// pairs: exact conditional p = 0.0703.
TEST(McNemar, IsThatOfFagerland) { EXPECT_NEAR(statistics::mcnemarTest(1, 7), 0.0703, 5e-5); }

TEST(McNemar, IsTheBinomialTest) {
  // 2 P(X <= 1), X ~ Bin(10, 1/2) = 2 (1 + 10) / 1024.
  EXPECT_NEAR(statistics::mcnemarTest(1, 9), 22.0 / 1024, 1e-12);
  EXPECT_NEAR(statistics::mcnemarTest(9, 1), 22.0 / 1024, 1e-12);
  EXPECT_EQ(statistics::mcnemarTest(4, 4), 1);
  EXPECT_EQ(statistics::mcnemarTest(0, 0), 1);
}

// The lady tasting tea: Agresti, Categorical Data Analysis (2002), 3.5.2: two-sided 0.486.
TEST(Fisher, IsTheLadysTea) { EXPECT_NEAR(statistics::fisherTest(3, 4, 1, 4), 34.0 / 70, 1e-9); }

// Benjamini and Hochberg, J. Royal Statistical Society B 57 (1995), 3.2: 15 p-values, of which
// Bonferroni at 0.05 and Hochberg, between which Holm lies, both reject the three smallest.
TEST(Holm, RejectsTheThreeOfBenjaminiAndHochberg) {
  const auto p =
      statistics::holmAdjusted({0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                                0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0000});
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(p[i] <= 0.05, i < 3) << i;
  EXPECT_NEAR(p[0], 15 * 0.0001, 1e-12);
  EXPECT_NEAR(p[3], 12 * 0.0095, 1e-12);
  EXPECT_EQ(p[14], 1);
}

// By hand, in any order: 4 x 0.005, 3 x 0.01, 2 x 0.03, and max(0.06, 0.04).
TEST(Holm, StepsDown) {
  const auto p = statistics::holmAdjusted({0.01, 0.04, 0.03, 0.005});
  EXPECT_NEAR(p[3], 0.02, 1e-12);
  EXPECT_NEAR(p[0], 0.03, 1e-12);
  EXPECT_NEAR(p[2], 0.06, 1e-12);
  EXPECT_NEAR(p[1], 0.06, 1e-12);
  EXPECT_TRUE(statistics::holmAdjusted({}).empty());
  EXPECT_THROW(statistics::holmAdjusted({0.5, 1.5}), core::Error);
}

// Efron, Annals of Statistics 7 (1979), section 3: the bootstrap median of 2 m - 1 values is above
// the k-th with the probability of fewer than m successes, Bin(2 m - 1, k / (2 m - 1)). For 13 it
// is up to the 3rd with 0.016, the 4th with 0.071, the 5th with 0.195: no tail of 0.025, 0.05 or
// 0.1 lies within 0.025 of one, over ten standard deviations of 9999 resamples.
TEST(MedianInterval, HasTheEndsOfEfronsExactDistribution) {
  const std::vector<double> values{7, 2, 13, 4, 5, 11, 1, 8, 9, 10, 6, 12, 3};
  const struct {
    double confidence, low, high;
  } cases[] = {{0.95, 4, 10}, {0.9, 4, 10}, {0.8, 5, 9}};
  for (const auto& c : cases) {
    core::RandomStream rng(1, 0, 0, core::Purpose::test);
    const auto i = statistics::medianInterval(values, rng, c.confidence);
    EXPECT_EQ(i.low, c.low) << c.confidence;
    EXPECT_EQ(i.high, c.high) << c.confidence;
  }
}

TEST(MedianInterval, IsReproducibleAndRefusesNonsense) {
  core::RandomStream a(1, 0, 0, core::Purpose::test);
  core::RandomStream b(1, 0, 0, core::Purpose::test);
  const auto i = statistics::medianInterval({1.5, 2.25, 7, 9, 30}, a, 0.95, 50);
  const auto j = statistics::medianInterval({1.5, 2.25, 7, 9, 30}, b, 0.95, 50);
  EXPECT_EQ(i.low, j.low);
  EXPECT_EQ(i.high, j.high);
  EXPECT_EQ(statistics::medianInterval({3}, a).low, 3);
  EXPECT_THROW(statistics::medianInterval({}, a), core::Error);
  EXPECT_THROW(statistics::medianInterval({1, NAN}, a), core::Error);
}
