#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/filter/recent_scans.h"
#include "ariadne/geometry/pose.h"
#include "room.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

constexpr double kGain = 8;

/// A robot that has driven 3 m through the room in ten updates and comes to its eleventh.
struct ShortDrive {
  explicit ShortDrive(double sigmas = 4) : recent({}, sigmas) {
    for (std::size_t k = 0; k < 10; ++k) {
      const TPose2D pose(-1.5 + 0.3 * static_cast<double>(k), -0.5, 0.05 * static_cast<double>(k));
      leaf = std::make_shared<filter::Ancestor>(leaf, k, pose, 0.0);
      recent.add(k, grid::makeScanShape(*test::scanIn(world, pose), {}), 0.3);
    }
    truth = geometry::compose(leaf->pose(), {0.3, 0, 0.05});
    points = grid::scanFeatures(*test::scanIn(world, truth), 40);
  }
  /// The room as a robot had it that came by it with an error.
  grid::OccupancyGrid roomOff(const TPose2D& by) const {
    grid::OccupancyGrid map((grid::GridParams()));
    for (int i = 0; i < 6; ++i) {
      const TPose2D pose(0.3 * i - 1, 0.2 * i - 0.8, i * M_PI / 3);
      map.insert(grid::makeScanShape(*test::scanIn(world, pose), {}), geometry::compose(by, pose));
    }
    return map;
  }
  models::Match settled(const grid::OccupancyGrid& map, const TPose2D& predicted) const {
    const Eigen::Matrix3d covariance = Eigen::Vector3d(0.04, 0.02, 0.01).cwiseAbs2().asDiagonal();
    const models::ScanMatcher matcher({}, kGain);
    const models::Match match = matcher(map, points, predicted, covariance);
    EXPECT_GT(
        std::hypot(match.map_from_robot.x - predicted.x, match.map_from_robot.y - predicted.y),
        0.2);  // it is disputed
    const models::PosePrior prior{predicted, covariance};
    if (!recent.dispute(match, prior)) return match;
    return filter::RecentScans::settled(match, recent.matched(prior, matcher, points, leaf), prior);
  }

  mrpt::maps::COccupancyGridMap2D world = test::roomWorld();
  filter::RecentScans recent;
  filter::AncestorPtr leaf;
  TPose2D truth;
  std::vector<mrpt::math::TPoint2D> points;
};

constexpr double kMatched_m = 0.07;  // one cell and what the coarse maps of this test leave

double offBy(const TPose2D& a, const TPose2D& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

TEST(RecentScans, AMapThatDoesNotFitYetDoesNotPullTheRobotIn) {
  const ShortDrive drive;
  const auto match = drive.settled(drive.roomOff({0.35, 0.2, 0.03}), drive.truth);
  EXPECT_LT(offBy(match.map_from_robot, drive.truth), kMatched_m);
}

TEST(RecentScans, NeverWithoutSigmas) {
  const ShortDrive drive(0);
  const auto match = drive.settled(drive.roomOff({0.35, 0.2, 0.03}), drive.truth);
  EXPECT_GT(offBy(match.map_from_robot, drive.truth), 0.2);
}

TEST(RecentScans, ARobotWhoseWheelsSlippedIsWhereBothMapsHaveIt) {
  const ShortDrive drive;
  const TPose2D slipped = geometry::compose(drive.truth, {0.35, 0.1, 0});
  const auto match = drive.settled(drive.roomOff({}), slipped);
  EXPECT_LT(offBy(match.map_from_robot, drive.truth), kMatched_m);
}

TEST(RecentScans, AKnownMapIsBelievedWhereNothingWasSeenLately) {
  ShortDrive drive;
  drive.leaf = nullptr;
  const TPose2D slipped = geometry::compose(drive.truth, {0.35, 0.1, 0});
  const auto match = drive.settled(drive.roomOff({}), slipped);
  EXPECT_LT(offBy(match.map_from_robot, drive.truth), kMatched_m);
}

TEST(RecentScans, HoldTheLastTenMetres) {
  filter::RecentScans recent({}, 4);
  const auto world = test::roomWorld();
  filter::AncestorPtr leaf;
  for (std::size_t k = 0; k < 12; ++k) {
    const TPose2D pose(0, 20.0 * static_cast<double>(k), 0);  // each room beside the one before
    leaf = std::make_shared<filter::Ancestor>(leaf, k, pose, 0.0);
    recent.add(k, grid::makeScanShape(*test::scanIn(world, {0, 0, 0}), {}), 2);
  }
  const auto box = recent.mapAlong(leaf).knownBox();
  const double height_m = (box.y1 - box.y0) * grid::GridParams().resolution_m;
  EXPECT_NEAR(height_m, 4 * 20 + 5.1, 1);  // five rooms of 5.1 m
}
