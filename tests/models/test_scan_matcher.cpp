#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/models/scan_matcher.h"
#include "room.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

Eigen::Matrix3d wide() { return Eigen::Vector3d(0.1, 0.1, 0.05).asDiagonal(); }

}  // namespace

// 40 poses off by up to 20 cm and 10 degrees: found to less than a cell's half and a third of a
// degree.
TEST(ScanMatcher, FindsThePoseFromNearby) {
  const auto world = test::roomWorld();
  const auto map = test::roomMap();
  const models::ScanMatcher matcher({}, 8);
  core::RandomStream rng(3, 0, 0, core::Purpose::test);
  for (int i = 0; i < 40; ++i) {
    const TPose2D truth(rng.uniform(), rng.uniform() - 0.5, 6 * rng.uniform());
    const auto points = grid::scanPoints(*test::scanIn(world, truth), 30);
    const TPose2D predicted(truth.x + 0.4 * (rng.uniform() - 0.5),
                            truth.y + 0.4 * (rng.uniform() - 0.5),
                            truth.phi + 0.35 * (rng.uniform() - 0.5));
    const auto match = matcher(map, points, predicted, wide());
    EXPECT_TRUE(match.accepted);
    EXPECT_NEAR(match.map_from_robot.x, truth.x, 0.025) << i;
    EXPECT_NEAR(match.map_from_robot.y, truth.y, 0.025) << i;
    EXPECT_NEAR(std::remainder(match.map_from_robot.phi - truth.phi, 2 * M_PI), 0, 0.0087) << i;
  }
}

TEST(ScanMatcher, KeepsThePredictionWhereThereIsNothingToSee) {
  const models::ScanMatcher matcher({}, 8);
  const TPose2D predicted(1, 2, 0.5);
  const auto points = grid::scanPoints(*test::scanIn(test::roomWorld(), {0, 0, 0}), 30);
  const auto in_void = matcher(grid::OccupancyGrid(), points, predicted, wide());
  EXPECT_FALSE(in_void.accepted);
  EXPECT_EQ(in_void.map_from_robot.x, predicted.x);
  const auto blind = matcher(test::roomMap(), {}, predicted, wide());
  EXPECT_FALSE(blind.accepted);
  EXPECT_EQ(blind.map_from_robot.y, predicted.y);
}

TEST(ScanMatcher, ANarrowPriorHoldsAgainstAFarMaximum) {
  const auto points = grid::scanPoints(*test::scanIn(test::roomWorld(), {0.1, 0, 0}), 30);
  const models::ScanMatcher matcher({}, 0.001);
  const TPose2D predicted(0.3, 0, 0);
  const Eigen::Matrix3d narrow = Eigen::Vector3d(1e-8, 1e-8, 1e-8).asDiagonal();
  const auto match = matcher(test::roomMap(), points, predicted, narrow);
  EXPECT_NEAR(match.map_from_robot.x, 0.3, 0.005);
}
