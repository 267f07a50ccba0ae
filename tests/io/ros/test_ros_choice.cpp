// Topics and frames: chosen by themselves where there is one of each, else asked for.
#include "ros_log.h"

using recording::drive;
using recording::Mcap;
using recording::turned;

namespace {

const std::vector<recording::Tf> kFixed = {{"base", "laser", {0.2, 0, 0.3}}};

class RosChoice : public RosLog {};

ariadne::io::RosOptions withScan(const std::string& topic) {
  ariadne::io::RosOptions ros;
  ros.scan_topic = topic;
  return ros;
}

/// Transforms odom -> base beside four scans; no nav_msgs/Odometry.
Mcap driveOnTf(const std::string& odom = "odom") {
  Mcap file;
  for (std::uint32_t i = 0; i < 4; ++i) {
    recording::Scan scan;
    scan.stamp = {1000 + i, 0};
    file.tf(scan.stamp, {{odom, "base", turned(0.5 * i, 0, 0)}}).scan(scan);
  }
  return file;
}

}  // namespace

TEST_F(RosChoice, OneOfEachNeedsNoOptions) {
  const auto r = read(drive().fixed(kFixed));
  ASSERT_EQ(r.error, "");
  ASSERT_EQ(r.steps.size(), 4U);
  EXPECT_EQ(r.steps[3].odom_from_robot, mrpt::math::TPose2D(1.5, 0, 0));
  EXPECT_EQ(r.steps[3].scan->sensorPose, mrpt::poses::CPose3D(0.2, 0, 0.3, 0, 0, 0));
}

TEST_F(RosChoice, SeveralLasersAreListed) {
  Mcap file = drive({"front", "rear"});
  file.fixed({{"base", "front", {0.2, 0, 0}}, {"base", "rear", turned(-0.3, 0, M_PI)}});
  expectTold(read(file),
             {"a.mcap: several lasers: /front/scan sensor_msgs/LaserScan (4), /rear/scan "
              "sensor_msgs/LaserScan (4)",
              "[dataset] scan_topic"});
  for (const char* name : {"/rear/scan", "rear/scan"}) {
    const auto r = read(file, withScan(name));
    ASSERT_EQ(r.error, "");
    EXPECT_EQ(r.label, "/rear/scan");
    EXPECT_EQ(r.steps.size(), 4U);
    EXPECT_EQ(r.counts.scans_other_lasers, 4U);
    EXPECT_NEAR(r.steps[0].scan->sensorPose.x(), -0.3, 1e-12);
  }
  expectTold(read(file, withScan("/scan")), {"no laser scans on the topic /scan", "/front/scan"});
}

TEST_F(RosChoice, TheLabelNamesTheTopicToo) {
  ariadne::io::writeWhole(
      folder / "b.mcap",
      drive({"front", "rear"}).fixed({{"base", "front", {}}, {"base", "rear", {}}}).bytes());
  EXPECT_EQ(sample::read(folder / "b.mcap", "/front/scan").label, "/front/scan");
}

TEST_F(RosChoice, OneTopicWithTwoFramesIsTwoLasers) {
  Mcap file = drive();
  recording::Scan other;
  other.stamp = {1004, 0};
  other.frame = "rear";
  file.scan(other).fixed({{"base", "laser", {}}, {"base", "rear", {}}});
  expectTold(read(file), {"several lasers: /scan:laser sensor_msgs/LaserScan (4), /scan:rear"});
  EXPECT_EQ(read(file, withScan("/scan:laser")).steps.size(), 4U);
}

TEST_F(RosChoice, SeveralOdometryTopicsAreListed) {
  Mcap file = drive().fixed(kFixed);
  for (std::uint32_t i = 0; i < 4; ++i)
    file.odom({1000 + i, 0}, turned(0, 0.5 * i, 0), "base", "/odometry/filtered");
  expectTold(read(file), {"several topics with odometry: /odom nav_msgs/Odometry (4), "
                          "/odometry/filtered nav_msgs/Odometry (4)",
                          "[dataset] odom_topic"});
  ariadne::io::RosOptions ros;
  ros.odom_topic = "odometry/filtered";
  EXPECT_EQ(read(file, ros).steps[3].odom_from_robot, mrpt::math::TPose2D(0, 1.5, 0));
  ros.odom_topic = "/wheels";
  expectTold(read(file, ros),
             {"no odometry on the topic /wheels; there is /odom nav_msgs/Odometry"});
}

TEST_F(RosChoice, OdometryFromTransforms) {
  Mcap file = driveOnTf().fixed(kFixed);
  file.tf({1001, 0}, {{"base", "wheel", turned(0, 0, 1)}, {"map", "odom", turned(1, 0, 0)}});
  file.tf({1002, 0}, {{"base", "wheel", turned(0, 0, 2)}, {"map", "odom", turned(2, 0, 0)}});
  const auto r = read(file);
  ASSERT_EQ(r.error, "");
  EXPECT_EQ(r.steps[3].odom_from_robot, mrpt::math::TPose2D(1.5, 0, 0));
}

TEST_F(RosChoice, OdometryThatNeverMovesIsStillOdometry) {
  Mcap file = Mcap().fixed(kFixed);
  for (std::uint32_t i = 0; i < 4; ++i) {
    recording::Scan scan;
    scan.stamp = {1000 + i, 0};
    file.tf(scan.stamp, {{"odom", "base", {}}}).scan(scan);
  }
  EXPECT_EQ(read(file).steps.size(), 4U);
}

TEST_F(RosChoice, AnotherFrameOfOdometry) {
  // What moves above the laser is odometry, whatever its name; of two it is asked for.
  EXPECT_EQ(read(driveOnTf("world").fixed(kFixed)).steps.size(), 4U);
  Mcap file = driveOnTf("odom").fixed(kFixed);
  for (std::uint32_t i = 0; i < 4; ++i)
    file.tf({1000 + i, 0}, {{"odom_combined", "base", turned(0, 1.0 * i, 0)}});
  expectTold(read(file),
             {"several transforms could be the odometry: odom -> base, odom_combined -> "
              "base",
              "[dataset] odom_frame"});
  ariadne::io::RosOptions ros;
  ros.odom_frame = "/odom_combined";
  EXPECT_EQ(read(file, ros).steps[3].odom_from_robot, mrpt::math::TPose2D(0, 3, 0));
  ros.odom_frame = "wheels";
  expectTold(read(file, ros), {"no odometry", "as [dataset] odom_frame"});
}

TEST_F(RosChoice, TransformsMayBeChosenBesideOdometry) {
  Mcap file = drive().fixed(kFixed);
  for (std::uint32_t i = 0; i < 4; ++i)
    file.tf({1000 + i, 0}, {{"odom", "base", turned(0, 0.25 * i, 0)}});
  EXPECT_EQ(read(file).steps[2].odom_from_robot, mrpt::math::TPose2D(1, 0, 0));
  ariadne::io::RosOptions ros;
  ros.odom_topic = "/tf";
  EXPECT_EQ(read(file, ros).steps[2].odom_from_robot, mrpt::math::TPose2D(0, 0.5, 0));
}

TEST_F(RosChoice, WithoutOdometry) {
  Mcap file = Mcap().fixed(kFixed).scan({}).scan({});
  expectTold(read(file), {"no odometry", "nav_msgs/Odometry", "/scan sensor_msgs/LaserScan (2)"});
  // Of messages that cannot be read it is said why.
  file.odom({1000, 0}, {0, 0, 0, 0, 0, 0, 0});
  expectTold(read(file), {"no odometry", "/odom", "a quaternion of length 0"});
}

TEST_F(RosChoice, PointCloudsOnly) {
  const Mcap file =
      Mcap().message("/points", "sensor_msgs/msg/PointCloud2", "...", {1000, 0}, "cdr");
  expectTold(read(file), {"no sensor_msgs/LaserScan", "point clouds", "pointcloud_to_laserscan",
                          "/points sensor_msgs/msg/PointCloud2 (1)"});
}

TEST_F(RosChoice, NoLaserAtAll) {
  expectTold(read(Mcap().odom({1000, 0}, {})), {"no sensor_msgs/LaserScan", "/odom"});
  expectTold(read(Mcap()), {"no sensor_msgs/LaserScan", "nothing"});
}

TEST_F(RosChoice, OtherLogsKnowNoTopics) {
  ariadne::io::writeWhole(folder / "a.log", sample::carmenLog(3));
  expectTold(readWith(folder / "a.log", withScan("/scan")),
             {"a.log: no recording of ROS: scan_topic", "mean nothing here"});
}

TEST_F(RosChoice, OtherSerializationIsTold) {
  const Mcap file =
      Mcap().message("/scan", "sensor_msgs/LaserScan", "{\"ranges\": []}", {1000, 0}, "json");
  expectTold(read(file), {"/scan are serialized as json", "cdr and ros1 are read"});
}
