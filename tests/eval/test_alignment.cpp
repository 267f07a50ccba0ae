#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/eval/alignment.h"
#include "ariadne/geometry/pose.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

geometry::Trajectory wander(int n) {
  core::RandomStream rng(1, 0, 0, core::Purpose::test);
  geometry::Trajectory path;
  TPose2D pose;
  for (int i = 0; i < n; ++i) {
    path.push_back({10.0 + i, pose});
    pose = geometry::compose(pose, {rng.uniform(), 0, rng.gaussian()});
  }
  return path;
}

}  // namespace

TEST(Associate, InterpolatesBetweenStampsAndTurnsTheShortWay) {
  const geometry::Trajectory estimate{{0, {0, 0, 3.1}}, {2, {4, 2, -3.1}}};
  const auto pairs = eval::associate(estimate, {{1, {0, 0, 0}}}, 5);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_NEAR(pairs[0].estimate.x, 2, 1e-12);
  EXPECT_NEAR(std::abs(std::remainder(pairs[0].estimate.phi - M_PI, 2 * M_PI)), 0, 1e-9);
}

TEST(Associate, LeavesOutWhatHasNoPartner) {
  const geometry::Trajectory estimate{{0, {}}, {1, {}}, {10, {}}, {11, {}}};
  const geometry::Trajectory truth{{-3, {}}, {-0.4, {}}, {0.5, {}}, {5, {}}, {10, {}}, {12, {}}};
  EXPECT_EQ(eval::associate(estimate, truth, 1).size(), 3U);
  EXPECT_TRUE(eval::associate({}, truth, 1).empty());
  EXPECT_TRUE(eval::associate(estimate, {}, 1).empty());
  EXPECT_EQ(eval::associate(estimate, truth, 0).size(), 1U);  // exact stamps only
}

TEST(Align, FindsTheRigidMotion) {
  const auto truth = wander(50);
  const TPose2D truth_from_estimate(3, -4, 2.2);
  geometry::Trajectory estimate;
  for (const auto& t : truth)
    estimate.push_back({t.time_s, geometry::relativePose(truth_from_estimate, t.pose)});
  const auto found = eval::align(eval::associate(estimate, truth, 1));
  EXPECT_NEAR(found.x, 3, 1e-9);
  EXPECT_NEAR(found.y, -4, 1e-9);
  EXPECT_NEAR(found.phi, 2.2, 1e-9);
}

TEST(Align, OnePoseOrNoneIsFine) {
  EXPECT_EQ(eval::align({}).x, 0);
  const auto found = eval::align({{0, {1, 2, 0.5}, {3, 4, 1.0}}});
  const auto laid = geometry::compose(found, {1, 2, 0.5});
  EXPECT_NEAR(laid.x, 3, 1e-12);
  EXPECT_NEAR(laid.y, 4, 1e-12);
  EXPECT_NEAR(laid.phi, 1, 1e-12);
}

// The alignment is a minimum: small moves of it only make things worse.
TEST(Align, NothingNearbyIsBetter) {
  const auto truth = wander(40);
  core::RandomStream rng(2, 0, 0, core::Purpose::test);
  std::vector<eval::PosePair> pairs;
  for (const auto& t : truth)
    pairs.push_back(
        {t.time_s, {t.pose.x + 0.1 * rng.gaussian(), t.pose.y + 0.1 * rng.gaussian(), 0}, t.pose});
  const auto cost = [&](const TPose2D& m) {
    double sum = 0;
    for (const auto& p : pairs) {
      const auto q = geometry::compose(m, p.estimate);
      sum += std::pow(q.x - p.truth.x, 2) + std::pow(q.y - p.truth.y, 2);
    }
    return sum;
  };
  const auto best = eval::align(pairs);
  for (const double d : {-1e-3, 1e-3}) {
    EXPECT_GT(cost({best.x + d, best.y, best.phi}), cost(best));
    EXPECT_GT(cost({best.x, best.y + d, best.phi}), cost(best));
    EXPECT_GT(cost({best.x, best.y, best.phi + d}), cost(best));
  }
}
