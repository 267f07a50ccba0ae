// Where the laser is: by fixed transforms, or as the user says; never silently at the centre.
#include "ros_log.h"

using mrpt::poses::CPose3D;
using recording::drive;
using recording::Mcap;
using recording::turned;

namespace {

class RosLaserPose : public RosLog {
 protected:
  static ariadne::io::RosOptions at(const std::string& text) {
    ariadne::io::RosOptions ros;
    ros.laser_pose = ariadne::io::parseLaserPose(text, "[dataset] laser_pose");
    return ros;
  }
  void expectPose(const sample::Result& r, const CPose3D& expected) {
    ASSERT_EQ(r.error, "");
    const CPose3D& pose = r.steps.at(0).scan->sensorPose;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(pose[static_cast<unsigned>(i)], expected[static_cast<unsigned>(i)], 1e-12);
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(pose.getRotationMatrix()(i, j), expected.getRotationMatrix()(i, j), 1e-12);
    }
  }
};

}  // namespace

TEST_F(RosLaserPose, ChainsAreComposedEitherWay) {
  // base -> deck -> arm, laser -> arm: the last one the wrong way round.
  const auto r = read(drive().fixed({{"deck", "arm", turned(0.1, 0, M_PI / 2)},
                                     {"base", "deck", {0.2, 0, 0.5}},
                                     {"laser", "arm", turned(0, -1, 0)}}));
  expectPose(r, CPose3D(0.2, 0, 0.5, 0, 0, 0) + CPose3D(0.1, 0, 0, M_PI / 2, 0, 0) +
                    CPose3D(0, 1, 0, 0, 0, 0));
}

TEST_F(RosLaserPose, FixedTransformsMayBeOnTf) {
  Mcap file = drive();
  for (std::uint32_t i = 0; i < 3; ++i)
    file.tf({1000 + i, 0}, {{"base", "laser", {0.1, 0.2, 0.3}}});
  expectPose(read(file), CPose3D(0.1, 0.2, 0.3, 0, 0, 0));
}

TEST_F(RosLaserPose, MayComeLate) {
  // tf_static behind all scans, as drive() has no transforms before it.
  expectPose(read(drive().fixed({{"base", "laser", {0.3, 0, 0}}})), CPose3D(0.3, 0, 0, 0, 0, 0));
}

TEST_F(RosLaserPose, ALaserInTheRobotsFrameIsAtItsCentre) {
  expectPose(read(drive({"base"})), CPose3D());
}

TEST_F(RosLaserPose, UpsideDown) {
  const auto r = read(drive().fixed({{"base", "laser", {0.1, 0, 0.4, 1, 0, 0, 0}}}));
  expectPose(r, CPose3D(0.1, 0, 0.4, 0, 0, M_PI));
  EXPECT_EQ(r.counts.scans_not_planar, 0U);
}

TEST_F(RosLaserPose, TiltedLasersAreNoMap) {
  const double half = M_PI / 8;
  const auto r =
      read(drive().fixed({{"base", "laser", {0, 0, 1, 0, std::sin(half), 0, std::cos(half)}}}));
  expectTold(r, {"4 scans skipped: the laser is tilted"});
}

TEST_F(RosLaserPose, UnknownIsAskedFor) {
  expectTold(read(drive()), {"where the laser is on the robot is not recorded",
                             "no transforms lead from base to laser", "[dataset] laser_pose",
                             "[dataset] base_frame"});
  expectTold(read(drive().fixed({{"base_link", "laser", {}}})), {"base_link -> laser"});
}

TEST_F(RosLaserPose, MayBeSaid) {
  expectPose(read(drive(), at("0 0 0")), CPose3D());
  expectPose(read(drive(), at("0.2 -0.1 90")), CPose3D(0.2, -0.1, 0, M_PI / 2, 0, 0));
  // It stands above what the recording says.
  expectPose(read(drive().fixed({{"base", "laser", {9, 0, 0}}}), at("0 0 180 upside_down")),
             CPose3D(0, 0, 0, M_PI, 0, M_PI));
}

TEST_F(RosLaserPose, BadValuesAreRefused) {
  for (const char* text : {"0 0", "0 0 0 0", "a b c", "0 0 nan", "0 0 0 upside_down 1", "1e9 0 0"})
    EXPECT_THROW(at(text), ariadne::core::UsageError) << text;
  EXPECT_FALSE(at("").laser_pose);
}

TEST_F(RosLaserPose, TheRobotsFrameMayBeSaid) {
  Mcap file;
  for (std::uint32_t i = 0; i < 3; ++i) {
    recording::Scan scan;
    scan.stamp = {1000 + i, 0};
    file.odom(scan.stamp, turned(i, 0, 0), "").scan(scan);
  }
  file.fixed({{"base_link", "laser", {0.5, 0, 0}}});
  expectTold(read(file), {"/odom names no child frame", "[dataset] base_frame"});
  // The transform of the same odometry names it.
  const Mcap silent = file;
  file.tf({1000, 0}, {{"odom", "base_link", {}}});
  expectPose(read(file), CPose3D(0.5, 0, 0, 0, 0, 0));
  file = silent;
  ariadne::io::RosOptions ros;
  ros.base_frame = "base_link";
  expectPose(read(file, ros), CPose3D(0.5, 0, 0, 0, 0, 0));
}

TEST_F(RosLaserPose, AMovingLaserIsTold) {
  Mcap file = drive();
  for (std::uint32_t i = 0; i < 3; ++i)
    file.tf({1000 + i, 0}, {{"base", "mast", {}}, {"mast", "laser", turned(0, 0, 0.3 * i)}});
  expectTold(read(file), {"the laser moves", "base -> mast, mast -> laser (moves)"});
}

TEST_F(RosLaserPose, WithoutAFrame) {
  expectTold(read(drive({""})), {"the scans name no frame", "laser_pose"});
}
