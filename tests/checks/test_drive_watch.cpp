#include <gtest/gtest.h>

#include <algorithm>

#include "ariadne/checks/drive_watch.h"
#include "room.h"

using namespace ariadne;
using checks::DriveWatch;

namespace {

models::SensorStep stepAt(double x, const mrpt::math::TPose2D& odom) {
  static const auto world = test::roomWorld();
  return {0, odom, test::scanIn(world, {x, -1, 0})};
}

mrpt::obs::CObservation2DRangeScan::Ptr blindScan(std::size_t returns) {
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->maxRange = 30;
  scan->resizeScan(100);
  for (std::size_t i = 0; i < 100; ++i) {
    scan->setScanRange(i, i < returns ? 2 : 30);
    scan->setScanRangeValidity(i, i < returns);
  }
  return scan;
}

}  // namespace

TEST(DriveWatch, ADriveIsNeitherBlindNorStanding) {
  DriveWatch watch({}, 0.1);
  for (int i = 0; i < 20; ++i) watch.add(stepAt(-1.5 + 0.1 * i, {0.1 * i, 0, 0}));
  EXPECT_EQ(watch.figures().scans, 20U);
  EXPECT_EQ(watch.figures().blind_scans, 0U);
  EXPECT_EQ(watch.figures().standing_scans, 0U);
  EXPECT_NEAR(watch.figures().odometry_m, 1.9, 1e-9);
}

TEST(DriveWatch, ARobotThatStandsIsFine) {
  DriveWatch watch({}, 0.1);
  for (int i = 0; i < 20; ++i) watch.add(stepAt(0, {1, 1, 1}));
  EXPECT_EQ(watch.figures().standing_scans, 0U);
}

TEST(DriveWatch, OdometryThatStopsIsSeen) {
  DriveWatch watch({}, 0.1);
  for (int i = 0; i < 30; ++i) watch.add(stepAt(-1.5 + 0.1 * i, {0.1 * std::min(i, 10), 0, 0}));
  EXPECT_GE(watch.figures().standing_scans, 13U);  // of 19; 0.3 m are driven first
  EXPECT_LE(watch.figures().standing_scans, 19U);
}

TEST(DriveWatch, CountsBlindScansByShareOfReturns) {
  DriveWatch watch({}, 0.1);
  for (const std::size_t returns : {0U, 9U, 10U, 50U}) watch.add({0, {}, blindScan(returns)});
  EXPECT_EQ(watch.figures().blind_scans, 2U);
  grid::GridParams short_sighted;
  short_sighted.insert_range_m = 1.5;
  DriveWatch near(short_sighted, 0.1);
  near.add({0, {}, blindScan(50)});
  EXPECT_EQ(near.figures().blind_scans, 1U);
  grid::GridParams clears;
  clears.no_return_free_m = 5;
  DriveWatch sees_space(clears, 0.1);
  sees_space.add({0, {}, blindScan(0)});
  EXPECT_EQ(sees_space.figures().blind_scans, 0U);  // an empty scan clears the map
}

TEST(DriveWatch, JumpsAreNoWay) {
  DriveWatch watch({}, 0.1);
  watch.add(stepAt(0, {0, 0, 0}));
  auto step = stepAt(0.1, {8, 0, 0});
  step.odometry_jumped = true;
  watch.add(step);
  watch.add(stepAt(0.2, {8.1, 0, 0}));
  EXPECT_NEAR(watch.figures().odometry_m, 0.1, 1e-9);
}
