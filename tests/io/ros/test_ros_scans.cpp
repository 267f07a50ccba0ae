// sensor_msgs/LaserScan as a scan: angles, what is a return, stamps.
#include "ros_log.h"

using recording::Mcap;
using recording::Scan;
using recording::turned;

namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class RosScans : public RosLog {
 protected:
  sample::Result readScan(Scan scan) {
    Mcap file;
    file.fixed({{"base", "laser", {}}});
    for (std::uint32_t i = 0; i < 3; ++i) {
      scan.stamp.s = 1000 + i;
      file.odom(scan.stamp, turned(i, 0, 0)).scan(scan);
    }
    return read(file);
  }
};

double angleOf(const mrpt::obs::CObservation2DRangeScan& scan, std::size_t beam) {
  const double step = scan.aperture / (static_cast<double>(scan.getScanSize()) - 1);
  const double from_end = scan.aperture / 2 - step * static_cast<double>(beam);
  return scan.sensorPose.yaw() + (scan.rightToLeft ? -from_end : from_end);
}

}  // namespace

TEST_F(RosScans, RangesAsRep117HasThem) {
  Scan scan;
  scan.ranges = {1, kInf, -kInf, kNan, 10, 11, 0.05F, 0, -1, 9.99F, 0.1F};
  scan.increment = 0.2F;
  const auto r = readScan(scan);
  ASSERT_EQ(r.steps.size(), 3U);
  const auto& s = *r.steps[0].scan;
  const std::vector<bool> valid = {true,  false, false, false, false, false,
                                   false, false, false, true,  true};
  const std::vector<bool> no_return = {false, true,  false, false, true, true,
                                       false, false, false, false, false};
  for (std::size_t i = 0; i < valid.size(); ++i) {
    EXPECT_EQ(s.getScanRangeValidity(i), valid[i]) << i;
    EXPECT_EQ(s.getScanRange(i) >= s.maxRange, no_return[i]) << i;
  }
  EXPECT_EQ(r.counts.beams_no_return, 9U);
  EXPECT_EQ(r.counts.beams_nan, 3U);
  EXPECT_EQ(r.counts.beams_out_of_range, 0U);
}

TEST_F(RosScans, BeamsLookWhereTheIncrementsLead) {
  for (const float increment : {0.5F, -0.5F})
    for (const float begin : {-1.F, -2.F, 3.F}) {
      Scan scan;
      scan.angle_min = begin;
      scan.increment = increment;
      // Right, one beam too far as some drivers have it, nonsense: the increments count.
      for (const float end : {begin + 4 * increment, begin + 5 * increment, 100.F}) {
        scan.angle_max = end;
        const auto r = readScan(scan);
        ASSERT_EQ(r.error, "");
        for (std::size_t i = 0; i < 5; ++i)
          EXPECT_NEAR(std::remainder(
                          angleOf(*r.steps[0].scan, i) - begin - increment * static_cast<double>(i),
                          2 * M_PI),
                      0, 1e-6);
      }
    }
}

TEST_F(RosScans, ReachThatNoLaserHas) {
  for (const float reach : {0.F, kInf, kNan, -1.F, 1e9F}) {
    Scan scan;
    scan.range_max = reach;
    scan.range_min = kNan;
    scan.ranges = {1, kInf, 90, 79, 2};
    const auto r = readScan(scan);
    ASSERT_EQ(r.steps.size(), 3U);
    EXPECT_EQ(r.steps[0].scan->maxRange, 80);
    EXPECT_TRUE(r.steps[0].scan->getScanRangeValidity(3));
    EXPECT_FALSE(r.steps[0].scan->getScanRangeValidity(2));
    EXPECT_TRUE(r.warns("/scan: range_max is " + fmt::format("{:g}", reach) + "; 80 m is taken"));
  }
}

TEST_F(RosScans, AllRound) {
  Scan scan;
  scan.ranges.assign(360, 2);
  scan.increment = static_cast<float>(2 * M_PI / 360);
  scan.angle_min = 0;
  scan.angle_max = static_cast<float>(2 * M_PI);
  const auto r = readScan(scan);
  ASSERT_EQ(r.error, "");
  EXPECT_NEAR(std::remainder(angleOf(*r.steps[0].scan, 90) - M_PI / 2, 2 * M_PI), 0, 1e-5);
}

TEST_F(RosScans, ImpossibleAnglesAreCounted) {
  Scan scan;
  scan.increment = 0;
  scan.angle_max = scan.angle_min;
  expectTold(readScan(scan), {"3 scans skipped: beams, angles"});
  scan.increment = kNan;
  expectTold(readScan(scan), {"3 scans skipped: beams, angles"});
  scan.increment = 3;
  expectTold(readScan(scan), {"3 scans skipped: beams, angles"});
}

TEST_F(RosScans, WithoutAStampTheRecordTimeCounts) {
  Mcap file;
  file.fixed({{"base", "laser", {}}});
  for (std::uint32_t i = 0; i < 3; ++i)
    file.message("/odom", "nav_msgs/Odometry", recording::odometry({0, 0}, turned(i, 0, 0)),
                 {1000 + i, 0})
        .message("/scan", "sensor_msgs/LaserScan", Scan().bytes(), {1000 + i, 500'000'000});
  const auto r = read(file);
  ASSERT_EQ(r.steps.size(), 3U);
  EXPECT_EQ(r.steps[1].time_s, 1001.5);
  EXPECT_DOUBLE_EQ(r.steps[1].odom_from_robot.x, 1.5);
}

TEST_F(RosScans, AClockThatIsSetBackLosesNothing) {
  Mcap file;
  file.fixed({{"base", "laser", {}}});
  for (std::uint32_t i = 0; i < 12; ++i) {
    Scan scan;
    scan.stamp = {i < 4 ? 1000 + i : 500 + i, 0};
    file.odom(scan.stamp, turned(0.1 * i, 0, 0)).scan(scan);
  }
  const auto r = read(file);
  ASSERT_EQ(r.steps.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_NEAR(r.steps[i].odom_from_robot.x, 0.1 * static_cast<double>(i), 1e-12);
}
