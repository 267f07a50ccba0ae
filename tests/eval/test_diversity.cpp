// Measures of diversity against closed forms and brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ariadne/core/random.h"
#include "ariadne/eval/ancestry_measures.h"
#include "ariadne/eval/kl_divergence.h"
#include "ariadne/eval/map_entropy.h"
#include "ariadne/eval/pose_entropy.h"

using namespace ariadne;
using filter::Ancestor;
using filter::AncestorPtr;
using geometry::WeightedPoses;

namespace {

WeightedPoses cloud(std::size_t n, double x, double sigma, std::uint64_t seed) {
  core::RandomStream rng(seed, 0, 0, core::Purpose::test);
  WeightedPoses set;
  for (std::size_t i = 0; i < n; ++i)
    set.poses.push_back({x + sigma * rng.gaussian(), sigma * rng.gaussian(), 0});
  set.weights.assign(n, 1.0 / static_cast<double>(n));
  return set;
}

/// A random family tree: `n` lines of `steps` nodes, resampled at every step.
std::vector<AncestorPtr> family(std::size_t n, std::size_t steps, std::uint64_t seed) {
  core::RandomStream rng(seed, 0, 0, core::Purpose::test);
  std::vector<AncestorPtr> leaves(n);
  for (std::size_t k = 0; k < steps; ++k) {
    std::vector<AncestorPtr> next;
    for (std::size_t i = 0; i < n; ++i) {
      const auto parent = k == 0 ? nullptr : leaves[rng.bits() % n];
      next.push_back(std::make_shared<Ancestor>(
          parent, k, mrpt::math::TPose2D(rng.gaussian(), rng.gaussian(), 0), 0.0));
    }
    leaves = next;
  }
  return leaves;
}

}  // namespace

TEST(Coalescence, IsThatOfBruteForce) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto leaves = family(12, 40, seed);
    const auto fast = eval::uniqueAncestors(leaves, 40);
    ASSERT_EQ(fast.size(), 40U);
    for (std::size_t k = 0; k < 40; ++k) {
      std::set<const Ancestor*> distinct;
      for (const auto& leaf : leaves) distinct.insert(filter::ancestorAt(leaf, k).get());
      EXPECT_EQ(fast[k], distinct.size());
      EXPECT_EQ(filter::distinctAncestors(leaves, k), distinct.size());
    }
    EXPECT_EQ(fast.back(), 12U);
  }
}

TEST(Divergence, OfASetFromItselfIsNothing) {
  const auto set = cloud(50, 0, 0.3, 1);
  const auto d = eval::divergence(set, set);
  EXPECT_EQ(d.kl_nats, 0);
  EXPECT_EQ(d.lost_mass, 0);
}

// KL of N(0, s^2 + h^2) and N(m, s^2 + h^2) in the plane is m^2 / 2 (s^2 + h^2). With 2000 samples
// over ten seeds the estimate was 0.96 to 1.06 of it.
TEST(Divergence, OfTwoCloudsIsThatOfTheirGaussians) {
  const double m = 0.6;
  const double s = 0.5;
  const double expected = m * m / (2 * (s * s + 0.01));
  const auto d = eval::divergence(cloud(2000, 0, s, 1), cloud(2000, m, s, 2));
  EXPECT_NEAR(d.kl_nats, expected, 0.12 * expected);
}

TEST(Divergence, OfASingleSurvivorIsNearTheFloor) {
  const auto set = cloud(60, 0, 2, 1);
  WeightedPoses one;
  one.poses = {set.poses[0]};
  one.weights = {1};
  const auto d = eval::divergence(set, one);
  EXPECT_GT(d.kl_nats, 5);
  EXPECT_LE(d.kl_nats, 12.5);
  EXPECT_GT(d.lost_mass, 0.9);
}

TEST(Divergence, IsThatOfBruteForce) {
  const auto p = cloud(9, 0, 0.2, 4);
  const auto q = cloud(7, 0.1, 0.2, 5);
  const double h = 0.1;
  const auto density = [&](const WeightedPoses& set, const mrpt::math::TPose2D& x) {
    double sum = 0;
    for (std::size_t j = 0; j < set.poses.size(); ++j) {
      const double d2 =
          (std::pow(x.x - set.poses[j].x, 2) + std::pow(x.y - set.poses[j].y, 2)) / (h * h);
      sum += set.weights[j] * std::exp(-d2 / 2) / (2 * M_PI * h * h);
    }
    return std::max(sum, std::exp(-12.5) / (2 * M_PI * h * h));
  };
  double kl = 0;
  for (std::size_t i = 0; i < p.poses.size(); ++i)
    kl += p.weights[i] * std::log(density(p, p.poses[i]) / density(q, p.poses[i]));
  EXPECT_NEAR(eval::divergence(p, q).kl_nats, kl, 1e-9);
}

TEST(Entropy, OfTheGaussianThatWasSampled) {
  const std::size_t n = 20000;
  core::RandomStream rng(1, 0, 0, core::Purpose::test);
  WeightedPoses set;
  for (std::size_t i = 0; i < n; ++i)
    set.poses.push_back({0.5 * rng.gaussian(), 0.2 * rng.gaussian(), 3.1 + 0.05 * rng.gaussian()});
  set.weights.assign(n, 1.0 / n);
  // ln((2 pi e)^3 |S|) / 2; the error of ln |S| is about sqrt(6 / n) = 0.017, half of it counts.
  const double expected = 1.5 * std::log(2 * M_PI * M_E) + std::log(0.5 * 0.2 * 0.05);
  EXPECT_NEAR(eval::gaussianEntropy(set), expected, 0.04);
}

TEST(Entropy, OfCellsIsTheClosedForm) {
  EXPECT_NEAR(eval::cellEntropy(0), std::log(2), 1e-12);
  for (const int l : {-127, -16, 8, 90}) {
    const double p = 1 / (1 + std::exp(-l / 16.0));
    EXPECT_NEAR(eval::cellEntropy(static_cast<std::int8_t>(l)),
                -p * std::log(p) - (1 - p) * std::log(1 - p), 1e-6);
  }
  grid::OccupancyGrid map;
  map.set({3, 4}, 16);
  map.set({-40, 4}, 16);
  double sum = 0;
  map.cells().forEachPacked([&](int, int, const grid::EvidenceTile& tile) {
    sum += eval::tileEntropy(map.cells().cellsOf(tile));
  });
  EXPECT_NEAR(sum, 2 * eval::cellEntropy(16), 1e-12) << "unknown cells do not count";
}
