#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/sim/drive.h"
#include "ariadne/sim/robot.h"
#include "corner_world.h"
#include "expect_error.h"

using namespace ariadne::sim;  // NOLINT: a test of this namespace
using ariadne::core::Error;
using ariadne::core::UsageError;
using ariadne::test::cornerPath;
using ariadne::test::cornerWorld;
using ariadne::test::expectError;

namespace {

double lengthOf(const TruthDrive& drive) {
  double sum = 0;
  for (std::size_t i = 1; i < drive.poses.size(); ++i)
    sum += (drive.poses[i].pose - drive.poses[i - 1].pose).norm();
  return sum;
}

/// Where a ray leaves the floor, by steps of 1/50 cell.
double castRay(const mrpt::maps::COccupancyGridMap2D& map, double x, double y, double angle) {
  const double step = map.getResolution() / 50;
  double range = 0;
  while (map.getPos(static_cast<float>(x + range * std::cos(angle)),
                    static_cast<float>(y + range * std::sin(angle))) > 0.5F)
    range += step;
  return range;
}

}  // namespace

TEST(Drive, IsTheSameEveryTime) {
  const World world = cornerWorld();
  const TruthDrive a = driveThrough(world, cornerPath(), {});
  const TruthDrive b = driveThrough(world, cornerPath(), {});
  ASSERT_EQ(a.poses.size(), b.poses.size());
  ASSERT_EQ(a.poses.size(), a.scans.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    EXPECT_EQ(a.poses[i].pose, b.poses[i].pose);
    EXPECT_EQ(a.scans[i]->getScanRange(7), b.scans[i]->getScanRange(7));
  }
}

TEST(Drive, PassesItsWaypointsAtItsSpeed) {
  const TruthDrive drive = driveThrough(cornerWorld(), cornerPath(0), {});
  EXPECT_EQ(drive.poses.front().pose, mrpt::math::TPose2D(0, 0, 0));
  const auto end = drive.poses.back().pose;
  // Reached within 0.3 m; then it rolls on for the motors' lag, 0.1 s, and less than a scan.
  EXPECT_LE(std::hypot(end.x - 12, end.y - 5), 0.35);
  EXPECT_NEAR(lengthOf(drive), 17, 0.7);  // corners are cut by 0.3 m
  double fastest = 0, turn = 0;
  for (std::size_t i = 1; i < drive.poses.size(); ++i) {
    const auto step = drive.poses[i].pose - drive.poses[i - 1].pose;
    EXPECT_DOUBLE_EQ(drive.poses[i].time_s, 0.2 * static_cast<double>(i));
    fastest = std::max(fastest, step.norm());
    turn = std::max(turn, std::abs(step.phi));
  }
  // The vehicle's clock ticks in 0.5 ms.
  EXPECT_NEAR(fastest, 0.6 * 0.2, 0.6 * 0.001);
  EXPECT_LE(turn, 60 * M_PI / 180 * 0.201);
}

TEST(Drive, LapsAreDriven) {
  const double none = lengthOf(driveThrough(cornerWorld(), cornerPath(0), {}));
  const double one = lengthOf(driveThrough(cornerWorld(), cornerPath(1), {}));
  const double four = lengthOf(driveThrough(cornerWorld(), cornerPath(4), {}));
  // 5 m there and back, less 0.3 m a turn, more what it rolls in the motors' lag.
  EXPECT_NEAR(one - none, 9.2, 0.4);
  EXPECT_NEAR(four - none, 4 * (one - none), 0.2);
}

TEST(Drive, MarksHaveTheTimesOfTheirPlaces) {
  const TruthDrive drive = driveThrough(cornerWorld(), cornerPath(), {});
  ASSERT_EQ(drive.marks.size(), 3U);
  EXPECT_EQ(drive.marks[0].name, "A");
  EXPECT_EQ(drive.marks[0].time_s, 0);
  EXPECT_EQ(drive.marks[1].name, "corner");
  const auto at = static_cast<std::size_t>(drive.marks[1].time_s * 5);
  const auto pose = drive.poses.at(at).pose;
  EXPECT_NEAR(std::hypot(pose.x - 12, pose.y), 0.3, 0.13);  // a scan's way at most
  EXPECT_LE(drive.marks[2].time_s, drive.poses.back().time_s);
  EXPECT_GT(drive.marks[2].time_s, drive.poses.back().time_s - 0.2);
}

TEST(Drive, ScansAgreeWithRaysThroughTheWorld) {
  const World world = cornerWorld();
  const TruthDrive drive = driveThrough(world, cornerPath(), {});
  const double cell = world.map.getResolution();
  int beams = 0, agree = 0;
  for (std::size_t i = 0; i < drive.poses.size(); i += 10) {
    const auto& pose = drive.poses[i].pose;
    const auto& scan = *drive.scans[i];
    ASSERT_EQ(scan.getScanSize(), 181U);
    for (std::size_t b = 0; b < 181; b += 3) {
      const double angle = pose.phi + (static_cast<double>(b) - 90) * M_PI / 180;
      const double over = scan.getScanRange(b) - castRay(world.map, pose.x, pose.y, angle);
      EXPECT_TRUE(scan.getScanRangeValidity(b));
      ++beams;
      agree += over > -0.1 * cell && over < 1.1 * cell ? 1 : 0;
    }
  }
  // MRPT's ranges are whole cells, the first beyond the face. Its rays are rounded to 1/1024 cell a
  // step, so that a few that graze a wall go another way: 1.8 % of 48,650 beams in nested.world.
  EXPECT_GT(beams, 1000);
  EXPECT_GT(agree, 0.97 * beams);
}

TEST(Drive, WallsBeyondTheRangeGiveNoReturn) {
  DriveParams params;
  params.max_range_m = 5;
  const TruthDrive drive = driveThrough(cornerWorld(), cornerPath(0), params);
  EXPECT_FALSE(drive.scans[0]->getScanRangeValidity(90));
  EXPECT_EQ(drive.scans[0]->getScanRange(90), 5);
  EXPECT_TRUE(drive.scans[0]->getScanRangeValidity(10));
}

// MRPT 2.5.8 sees 0.8 of the range that it is asked for.
TEST(Drive, WallsAreSeenUpToTheRange) {
  const World world = parseWorld("room 0 0 12 4\nstart 1 2 0\n", "long.world");
  DriveParams params;
  for (const double range_m : {11.2, 12.0, 13.0}) {
    params.max_range_m = range_m;
    const auto scan = Robot(world, *world.start, params).scan();
    EXPECT_TRUE(scan->getScanRangeValidity(90)) << range_m;
    EXPECT_NEAR(scan->getScanRange(90), 11, 0.06) << range_m;
    EXPECT_EQ(scan->maxRange, static_cast<float>(range_m));
  }
  params.max_range_m = 10.9;
  const auto scan = Robot(world, *world.start, params).scan();
  EXPECT_FALSE(scan->getScanRangeValidity(90));
  EXPECT_EQ(scan->getScanRange(90), 10.9F);
}

TEST(Drive, TouchingRockIsAnError) {
  const auto path = parsePath("goto 4 0\ngoto 4 7", "p");
  expectError<Error>([&] { driveThrough(cornerWorld(), path, {}); },
                     {"corner.world", "after", "s, at (3.99", "waypoint (4, 0) of p:1",
                      "touches rock with its radius of 0.2 m"});
  DriveParams fat;
  fat.robot_radius_m = 1.2;
  expectError<Error>([&] { driveThrough(cornerWorld(), cornerPath(), fat); },
                     {"corner.world", "at its start (0.00, 0.00)", "radius of 1.2 m"});
}

TEST(Drive, ParametersAreChecked) {
  DriveParams params;
  params.beams = 1;
  expectError<UsageError>([&] { driveThrough(cornerWorld(), cornerPath(), params); },
                          {"[drive] beams = 1", "2 to 10000"});
}

TEST(Drive, OtherRatesDriveTheSameWay) {
  DriveParams fast;
  fast.scan_rate_hz = 20;
  const TruthDrive a = driveThrough(cornerWorld(), cornerPath(), {});
  const TruthDrive b = driveThrough(cornerWorld(), cornerPath(), fast);
  // The same control period, 0.05 s: only the vehicle's ticks of 0.5 ms differ.
  for (std::size_t i = 0; i < a.poses.size() && 4 * i < b.poses.size(); ++i)
    EXPECT_LT((a.poses[i].pose - b.poses[4 * i].pose).norm(), 0.01);
  EXPECT_NEAR(a.poses.back().time_s, b.poses.back().time_s, 0.2);
}
