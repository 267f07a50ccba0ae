#include <gtest/gtest.h>

#include "ariadne/grid/scan_shape.h"
#include "scans.h"

using namespace ariadne;
using mrpt::poses::CPose3D;

TEST(ScanShape, PointsAreWhereMrptPutsThem) {
  auto scan = test::randomScan(3);
  scan.sensorPose = CPose3D(0.2, -0.1, 0.4, 0.3, 0, 0);
  const auto points = grid::scanPoints(scan, 100);
  ASSERT_EQ(points.size(), scan.getScanSize());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double a = scan.getScanAngle(i);
    const double r = scan.getScanRange(i);
    double x = 0;
    double y = 0;
    double z = 0;
    scan.sensorPose.composePoint(r * std::cos(a), r * std::sin(a), 0, x, y, z);
    EXPECT_NEAR(points[i].x, x, 1e-5);  // MRPT's angle is a float
    EXPECT_NEAR(points[i].y, y, 1e-5);
  }
}

TEST(ScanShape, UpsideDownMirrorsTheScan) {
  auto scan = test::randomScan(4);
  const auto upright = grid::scanPoints(scan, 100);
  scan.sensorPose = CPose3D(0, 0, 0, 0, 0, M_PI);
  const auto mirrored = grid::scanPoints(scan, 100);
  ASSERT_EQ(mirrored.size(), upright.size());
  for (std::size_t i = 0; i < upright.size(); ++i) {
    EXPECT_NEAR(mirrored[i].x, upright[i].x, 1e-9);
    EXPECT_NEAR(mirrored[i].y, -upright[i].y, 1e-9);
  }
}

TEST(ScanShape, ClockwiseBeamsAreTheMirroredOnes) {
  auto scan = test::randomScan(4);
  const auto counterclockwise = grid::scanPoints(scan, 100);
  scan.rightToLeft = false;
  const auto clockwise = grid::scanPoints(scan, 100);
  for (std::size_t i = 0; i < clockwise.size(); ++i)
    EXPECT_NEAR(clockwise[i].y, -counterclockwise[i].y, 1e-9);
}

TEST(ScanShape, BadBeamsHitNothing) {
  auto scan = test::scanOf(8, [](std::size_t i) {
    const double ranges[] = {1, std::nan(""), 0, -3, HUGE_VAL, 81, 40, 2};
    return ranges[i];
  });
  const auto shape = grid::makeScanShape(scan, {});
  EXPECT_EQ(shape.hits.size(), 2U);  // 1 m and 2 m; 40 m is past the insertion range
  for (const auto& p : shape.outline) {
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
    EXPECT_LT(std::hypot(p.x, p.y), 30.001);
  }
}

TEST(ScanShape, NoReturnClearsOnlyWhenAsked) {
  auto scan = test::scanOf(181, [](std::size_t) { return 80.0; });
  for (std::size_t i = 0; i < 181; ++i) scan.setScanRangeValidity(i, false);
  const auto farthest = [&](double no_return_free_m) {
    grid::GridParams params;
    params.no_return_free_m = no_return_free_m;
    double far = 0;
    for (const auto& p : grid::makeScanShape(scan, params).outline)
      far = std::max(far, std::hypot(p.x, p.y));
    return far;
  };
  EXPECT_NEAR(farthest(0), 0, 1e-9);
  EXPECT_NEAR(farthest(5), 5, 1e-6);
}

TEST(ScanShape, OneBeamOrNoneIsNoArea) {
  for (std::size_t n : {0U, 1U})
    EXPECT_TRUE(
        grid::makeScanShape(test::scanOf(n, [](std::size_t) { return 3.0; }), {}).outline.empty());
}
