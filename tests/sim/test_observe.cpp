#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/sim/drive.h"
#include "corner_world.h"

using namespace ariadne::sim;  // NOLINT: a test of this namespace
using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;

namespace {

constexpr int kCount = 4000;

/// The same increment again and again, with beams at 5 m, at the maximum range less 1 mm, and one
/// without return.
TruthDrive uniformDrive(const TPose2D& increment) {
  auto scan = CObservation2DRangeScan::Create();
  scan->maxRange = 20;
  scan->resizeScan(3);
  const float ranges[3] = {5, 19.999F, 20};
  for (int i = 0; i < 3; ++i) {
    scan->setScanRange(i, ranges[i]);
    scan->setScanRangeValidity(i, i < 2);
  }
  TruthDrive drive;
  TPose2D pose;
  for (int k = 0; k <= kCount; ++k) {
    drive.poses.push_back({0.2 * k, pose});
    drive.scans.push_back(scan);
    pose = pose + increment;
  }
  return drive;
}

struct Spread {
  double x = 0, y = 0, phi = 0;
};

/// Standard deviations of kCount increments about the true one. With 4000 draws a sample deviation
/// is within 5 % of the true one in 4.5 sigma.
Spread spreadOf(const TPose2D& increment, const NoiseParams& noise) {
  const SimulatedDrive seen = observe(uniformDrive(increment), noise, 3);
  Spread sum;
  for (int k = 1; k <= kCount; ++k) {
    const TPose2D step = seen.steps[k].odom_from_robot - seen.steps[k - 1].odom_from_robot;
    sum.x += std::pow(step.x - increment.x, 2);
    sum.y += std::pow(step.y - increment.y, 2);
    sum.phi += std::pow(std::remainder(step.phi - increment.phi, 2 * M_PI), 2);
  }
  return {std::sqrt(sum.x / kCount), std::sqrt(sum.y / kCount), std::sqrt(sum.phi / kCount)};
}

}  // namespace

TEST(Observe, OdometrySpreadsAsItSays) {
  const NoiseParams noise{0.05, 0.5, 0.05, 0.02, 0};
  const Spread straight = spreadOf({0.12, 0, 0}, noise);
  EXPECT_NEAR(straight.x / (0.05 * std::sqrt(0.12)), 1, 0.05);
  EXPECT_NEAR(straight.y / (0.02 * std::sqrt(0.12)), 1, 0.05);
  EXPECT_NEAR(straight.phi / (0.5 * M_PI / 180 * std::sqrt(0.12)), 1, 0.05);
  const Spread turn = spreadOf({0, 0, -0.2}, noise);
  EXPECT_NEAR(turn.phi / (0.05 * std::sqrt(0.2)), 1, 0.05);
  EXPECT_LT(turn.x + turn.y, 1e-12);
  const Spread sideways = spreadOf({0, 0.12, 0}, noise);
  EXPECT_NEAR(sideways.y / (0.05 * std::sqrt(0.12)), 1, 0.05);
}

TEST(Observe, VarianceGrowsWithTheWayNotWithTheScans) {
  const NoiseParams noise{0.1, 1, 0.1, 0.05, 0};
  const Spread whole = spreadOf({0.2, 0, 0.1}, noise);
  const Spread half = spreadOf({0.1, 0, 0.05}, noise);
  EXPECT_NEAR(2 * std::pow(half.phi, 2) / std::pow(whole.phi, 2), 1, 0.15);  // 1.05^2 / 0.95^2
  EXPECT_NEAR(2 * std::pow(half.x, 2) / std::pow(whole.x, 2), 1, 0.15);
}

TEST(Observe, RangesSpreadAsTheySay) {
  const SimulatedDrive seen = observe(uniformDrive({0.1, 0, 0}), {0, 0, 0, 0, 0.03}, 3);
  double mean = 0, square = 0;
  int lost = 0;
  for (const auto& step : seen.steps) {
    const double error = step.scan->getScanRange(0) - 5;
    mean += error / (kCount + 1);
    square += error * error / (kCount + 1);
    EXPECT_TRUE(step.scan->getScanRangeValidity(0));
    // The contract of io::StepSource.
    EXPECT_EQ(step.scan->getScanRangeValidity(1), step.scan->getScanRange(1) < 20);
    EXPECT_LE(step.scan->getScanRange(1), 20);
    lost += step.scan->getScanRangeValidity(1) ? 0 : 1;
    EXPECT_FALSE(step.scan->getScanRangeValidity(2));
    EXPECT_EQ(step.scan->getScanRange(2), 20);
  }
  EXPECT_NEAR(mean, 0, 4.5 * 0.03 / std::sqrt(kCount));
  EXPECT_NEAR(std::sqrt(square) / 0.03, 1, 0.05);
  // P(N(0, 0.03) > 0.001) = 0.487, with 4.5 sigma of a share of 4001.
  EXPECT_NEAR(lost / (kCount + 1.0), 0.487, 0.036);
}

TEST(Observe, SameSeedSameBits) {
  const TruthDrive drive =
      driveThrough(ariadne::test::cornerWorld(), ariadne::test::cornerPath(), {});
  const SimulatedDrive a = observe(drive, {}, 7), b = observe(drive, {}, 7),
                       c = observe(drive, {}, 8);
  ASSERT_EQ(a.steps.size(), drive.poses.size());
  for (std::size_t k = 0; k < a.steps.size(); ++k) {
    EXPECT_EQ(a.steps[k].odom_from_robot, b.steps[k].odom_from_robot);
    for (std::size_t i = 0; i < 181; ++i)
      EXPECT_EQ(a.steps[k].scan->getScanRange(i), b.steps[k].scan->getScanRange(i));
  }
  EXPECT_NE(a.steps[9].odom_from_robot, c.steps[9].odom_from_robot);
  EXPECT_NE(a.steps[9].scan->getScanRange(0), c.steps[9].scan->getScanRange(0));
  EXPECT_EQ(a.steps[0].odom_from_robot, TPose2D());
  EXPECT_EQ(a.truth[9].pose, drive.poses[9].pose);
  EXPECT_EQ(a.marks.size(), 3U);
  EXPECT_NE(a.steps[9].scan, b.steps[9].scan) << "each observation owns its scans";
}

TEST(Observe, NoNoiseIsTheTruth) {
  const TruthDrive drive =
      driveThrough(ariadne::test::cornerWorld(), ariadne::test::cornerPath(), {});
  const SimulatedDrive seen = observe(drive, {0, 0, 0, 0, 0}, 7);
  for (std::size_t k = 0; k < seen.steps.size(); ++k) {
    const TPose2D pose = drive.poses[0].pose + seen.steps[k].odom_from_robot;
    EXPECT_LT((pose - drive.poses[k].pose).norm(), 1e-9);
    EXPECT_EQ(seen.steps[k].scan->getScanRange(40), drive.scans[k]->getScanRange(40));
  }
}

TEST(Observe, ParametersAreChecked) {
  NoiseParams noise;
  noise.range_sigma_m = -1;
  EXPECT_THROW(observe({}, noise, 1), ariadne::core::UsageError);
}
