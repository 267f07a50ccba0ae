#include <gtest/gtest.h>

#include <algorithm>

#include "ariadne/grid/insertion/scan_shape.h"
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

namespace {

/// A wall 2 m to the left and nothing else, seen up to 8 m: by 76 of 181 beams.
mrpt::obs::CObservation2DRangeScan wallAlongside() {
  auto scan = test::scanOf(181, [](std::size_t i) {
    const double across = std::sin((static_cast<double>(i) - 90) * M_PI / 180);
    return across > 0 && 2 / across < 8 ? 2 / across : 8.0;
  });
  scan.maxRange = 8;
  for (std::size_t i = 0; i < 181; ++i) scan.setScanRangeValidity(i, scan.getScanRange(i) < 8);
  return scan;
}

}  // namespace

TEST(ScanFeatures, LeaveOutWhereReachEndsAWall) {
  auto scan = wallAlongside();
  for (std::size_t i = 140; i < 181; ++i) scan.setScanRangeValidity(i, false);
  for (std::size_t i = 140; i < 181; ++i) scan.setScanRange(i, 0);  // bad beams, no horizon
  const auto all = grid::scanPoints(scan, 30);
  const auto kept = grid::scanFeatures(scan, 30);
  ASSERT_GT(all.size(), 10U);
  ASSERT_LT(kept.size(), all.size());
  const double end_m = all.front().x;  // beams go round from the right, the far end comes first
  EXPECT_GT(end_m, 7);
  for (const auto& p : all) {
    const bool cut_off = end_m - p.x < 0.5;
    const bool is_kept = std::any_of(kept.begin(), kept.end(),
                                     [&](const auto& k) { return k.x == p.x && k.y == p.y; });
    EXPECT_NE(cut_off, is_kept) << p.x;
  }
}

TEST(ScanFeatures, AreAllPointsWhereManyBeamsReturned) {
  const auto scan = test::randomScan(3);
  EXPECT_EQ(grid::scanFeatures(scan, 100).size(), grid::scanPoints(scan, 100).size());
  const auto wall = wallAlongside();
  EXPECT_EQ(grid::scanFeatures(wall, 30).size(), grid::scanPoints(wall, 30).size());
  EXPECT_LT(grid::scanFeatures(wall, 30, 1).size(), grid::scanPoints(wall, 30).size());
}

TEST(ScanFeatures, APillarIsKeptWhole) {
  auto scan = test::scanOf(181, [](std::size_t i) { return i >= 80 && i < 90 ? 2 : 8.0; });
  scan.maxRange = 8;
  EXPECT_EQ(grid::scanFeatures(scan, 30).size(), 10U);
  const auto none = test::scanOf(181, [](std::size_t) { return 100.0; });
  EXPECT_TRUE(grid::scanFeatures(none, 30).empty());
}
