#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/random.h"

using ariadne::core::Purpose;
using ariadne::core::RandomStream;

TEST(RandomStream, SameKeySameNumbers) {
  RandomStream a(7, 3, 2, Purpose::motion);
  RandomStream b(7, 3, 2, Purpose::motion);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(RandomStream, EveryPartOfTheKeyMatters) {
  const auto first = [](std::uint64_t seed, std::uint32_t step, std::uint32_t particle, Purpose p) {
    return RandomStream(seed, step, particle, p).bits();
  };
  const auto base = first(1, 1, 1, Purpose::motion);
  EXPECT_NE(base, first(2, 1, 1, Purpose::motion));
  EXPECT_NE(base, first((1ULL << 40) + 1, 1, 1, Purpose::motion));
  EXPECT_NE(base, first(1, 2, 1, Purpose::motion));
  EXPECT_NE(base, first(1, 1, 2, Purpose::motion));
  EXPECT_NE(base, first(1, 1, 1, Purpose::proposal));
}

// n = 40000: the standard error of the mean is 0.005, of the variance 0.007; bounds are 4 of them.
TEST(RandomStream, GaussianHasMeanZeroAndVarianceOne) {
  RandomStream rng(5, 0, 0, Purpose::test);
  double sum = 0;
  double squares = 0;
  const int n = 40000;
  for (int i = 0; i < n; ++i) {
    const double g = rng.gaussian();
    sum += g;
    squares += g * g;
  }
  EXPECT_NEAR(sum / n, 0, 0.02);
  EXPECT_NEAR(squares / n, 1, 0.03);
}

TEST(RandomStream, UniformStaysInsideTheOpenInterval) {
  RandomStream rng(5, 0, 0, Purpose::test);
  double sum = 0;
  const int n = 40000;
  for (int i = 0; i < n; ++i) {
    const double u = rng.uniform();
    ASSERT_GT(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
  }
  EXPECT_NEAR(sum / n, 0.5, 0.006);  // 4 standard errors of 0.289 / sqrt(n)
}
