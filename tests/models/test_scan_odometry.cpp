#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/geometry/pose.h"
#include "ariadne/models/scan_odometry.h"
#include "slam/drive.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

/// How far a pose is from the truth, both seen from the first, m.
double errorOf(const TPose2D& pose, const test::RecordedDrive& drive, std::size_t step) {
  const auto truth = geometry::relativePose(drive.truth[0], drive.truth[step]);
  return std::hypot(pose.x - truth.x, pose.y - truth.y);
}

}  // namespace

// Odometry 3 % and 2 % off ends 0.75 to 1.1 m from the truth; this never reads it.
TEST(ScanOdometry, FollowsTheOvalByScansAlone) {
  auto drive = test::ovalDrive(200);
  models::ScanOdometry odometry({}, {}, 8);
  for (std::size_t i = 0; i < drive.steps.size(); ++i) {
    drive.steps[i].odom_from_robot = {};
    EXPECT_LT(errorOf(odometry.add(drive.steps[i]), drive, i), 0.15) << i;
  }
  EXPECT_EQ(odometry.lost(), 0U);
}

TEST(ScanOdometry, GoesOnAsBeforeWhereAScanShowsNothing) {
  auto drive = test::ovalDrive(30);
  for (std::size_t i = 15; i < 18; ++i)
    for (std::size_t beam = 0; beam < drive.steps[i].scan->getScanSize(); ++beam)
      drive.steps[i].scan->setScanRangeValidity(beam, false);
  models::ScanOdometry odometry({}, {}, 8);
  TPose2D last;
  for (const auto& step : drive.steps) last = odometry.add(step);
  EXPECT_EQ(odometry.lost(), 3U);
  EXPECT_LT(errorOf(last, drive, 29), 0.1);
}
