// Lasers of a CARMEN log: which lines are used, where the laser sits, how far it sees.
#include "carmen_geometry.h"

using namespace sample;  // NOLINT: a test of these samples

class CarmenLaserLines : public CarmenGeometry {};

TEST_F(CarmenLaserLines, ParamsSayWhereALaserSitsWhenItsLinesDoNot) {
  const std::string params =
      "PARAM robot_frontlaser_offset 0.3\nPARAM robot_frontlaser_side_offset -0.1\n"
      "PARAM robot_frontlaser_angular_offset 0.5\n";
  const Read r = readLog(params + flasers(181));
  ASSERT_EQ(r.steps.size(), 3U) << r.error;
  EXPECT_NEAR(r.steps[0].scan->sensorPose.x(), 0.3, 1e-9);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.y(), -0.1, 1e-9);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.yaw(), 0.5, 1e-6);
  EXPECT_TRUE(r.notesThat("at x 0.300 y -0.100 m, yaw 28.65 degrees, by PARAM"));
  // A rear laser looks back, its offset counts along its axis (CARMEN's robot_laser.c).
  const Read rear = readLog("PARAM robot_rearlaser_offset 0.2\n" + flasers(181, 3, "RLASER"));
  ASSERT_EQ(rear.steps.size(), 3U) << rear.error;
  EXPECT_NEAR(rear.steps[0].scan->sensorPose.x(), -0.2, 1e-9);
  expectFan(rear, 90, 270);
  const Read turned = readLog(
      "PARAM robot_rearlaser_offset -0.2\nPARAM robot_rearlaser_angular_offset 3.1415923\n" +
      flasers(181, 3, "RLASER"));
  ASSERT_EQ(turned.steps.size(), 3U) << turned.error;
  EXPECT_NEAR(turned.steps[0].scan->sensorPose.x(), -0.2, 1e-9);
  EXPECT_NEAR(std::abs(turned.steps[0].scan->sensorPose.yaw()), M_PI, 1e-5);
}

TEST_F(CarmenLaserLines, LinesThatAgreeOnAnOffsetWin) {
  std::string text = "PARAM robot_frontlaser_offset 0.6\n";
  for (int i = 0; i < 20; ++i)
    text +=
        flaser(181, "1", fmt::format("{} 2 0", i + 0.3), fmt::format("{} 2 0", i), kBegin_s + i);
  const Read r = readLog(text);
  ASSERT_EQ(r.steps.size(), 20U) << r.error;
  EXPECT_NEAR(r.steps[9].scan->sensorPose.x(), 0.3, 1e-6);
  EXPECT_TRUE(r.warns("PARAM robot_frontlaser_offset 0.6 is not used"));
}

TEST_F(CarmenLaserLines, AParamsMaximumRangeIsBelievedWhenReadingsKeepIt) {
  const std::string param = "PARAM robot_front_laser_max 50.0\n";
  std::string codes = param + flasers(181, 1);
  codes += flaser(181, "51.15", "0 0 0", "0 0 0", kBegin_s + 3);
  const Read r = readLog(codes);
  ASSERT_EQ(r.steps.size(), 2U) << r.error;
  EXPECT_EQ(r.steps[0].scan->maxRange, 50);
  EXPECT_FALSE(r.steps[1].scan->getScanRangeValidity(7));
  EXPECT_EQ(r.counts.beams_no_return, 181U);
  std::string walls = param;
  for (int i = 0; i < 9; ++i)
    walls += flaser(181, fmt::format("{}", 52 + i), "0 0 0", "0 0 0", kBegin_s + i);
  const Read far = readLog(walls);
  ASSERT_EQ(far.steps.size(), 9U) << far.error;
  EXPECT_EQ(far.steps[0].scan->maxRange, 80);
  EXPECT_TRUE(far.warns("robot_front_laser_max 50.0 is not used"));
}

TEST_F(CarmenLaserLines, RawLasersTakeTheirPosesFromOdometry) {
  std::string text = "PARAM robot_frontlaser_offset 0.25\n";
  for (int i = 0; i < 20; ++i) {
    text += fmt::format("ODOM {} 0 0.2 1 0 0 {:.6f} host {:.6f}\n", 0.5 * i, kBegin_s + i, 1.0 * i);
    text += robotlaser("-2.356194 4.712389 0.008726646", 541, kBegin_s + i + 0.25, "RAWLASER1");
  }
  const Read r = readLog(text);
  ASSERT_EQ(r.steps.size(), 20U) << r.error;
  EXPECT_EQ(r.label, "RAWLASER1");
  for (std::size_t i = 0; i < 19; ++i) {
    EXPECT_NEAR(r.steps[i].odom_from_robot.x, 0.5 * double(i) + 0.125, 1e-6);
    EXPECT_EQ(r.steps[i].odom_from_robot.phi, 0.2);
    EXPECT_EQ(r.steps[i].time_s, kBegin_s + double(i) + 0.25);
  }
  expectFan(r, -135, 135);
  EXPECT_EQ(r.steps[0].scan->maxRange, 30);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.x(), 0.25, 1e-9);
  EXPECT_NEAR(r.steps[0].scan->getScanRange(540), 6.4, 1e-6);
  EXPECT_TRUE(r.warnings.empty());
  // Without the PARAM its place is told to be a guess; without ODOM there is no pose.
  const Read unplaced = readLog(text.substr(text.find('\n') + 1));
  EXPECT_EQ(unplaced.steps.size(), 20U) << unplaced.error;
  EXPECT_TRUE(unplaced.warns("nothing says where the laser sits"));
  const std::string alone = robotlaser("-1.57 3.14 0.01745", 181, kBegin_s, "RAWLASER1");
  EXPECT_NE(readLog(alone).error.find("no odometry"), std::string::npos);
}

TEST_F(CarmenLaserLines, LinesWithPosesAreUsedWhereThereAreSuch) {
  std::string text;
  for (int i = 0; i < 5; ++i) {
    text += fmt::format("ODOM {} 0 0 0 0 0 {:.6f} host 1\n", i, kBegin_s + i);
    text += robotlaser("-1.570796 3.141593 0.01745329", 181, kBegin_s + i, "RAWLASER1");
    text += robotlaser("-1.570796 3.141593 0.01745329", 181, kBegin_s + i, "RAWLASER3");
    text += robotlaser("-1.570796 3.141593 0.01745329", 181, kBegin_s + i);
  }
  const Read r = readLog(text);
  EXPECT_EQ(r.steps.size(), 5U) << r.error;
  EXPECT_EQ(r.label, "ROBOTLASER1");
  EXPECT_TRUE(r.warns("RAWLASER3 lines are left out"));
  EXPECT_FALSE(r.warns("RAWLASER1"));
}

TEST_F(CarmenLaserLines, OldLinesLackARemissionModeAndATurningAxis) {
  const std::string old = fmt::format(
      "ROBOTLASER1 0 -1 2 0.5 20 0.01 5 1 2 3 4 5 0 1.5 2 0 1 2 0 0 0 0 0 {:.3f} h 1\n", kBegin_s);
  const Read r = readLog(old);
  ASSERT_EQ(r.steps.size(), 1U) << r.error;
  EXPECT_EQ(r.steps[0].time_s, kBegin_s);
  EXPECT_EQ(r.steps[0].scan->getScanRange(4), 5);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.x(), 0.5, 1e-6);
}

TEST_F(CarmenLaserLines, TwoLasersNeedAChoiceAndTheErrorSaysHow) {
  const Read r = readLog(flasers(181) + flasers(181, 3, "RLASER"));
  for (const char* part : {"FLASER (3 scans), RLASER (3 scans)", "laser_label", "--laser"})
    EXPECT_NE(r.error.find(part), std::string::npos) << r.error;
  EXPECT_EQ(readLog(flasers(181) + flasers(181, 3, "RLASER"), 0, "RLASER").steps.size(), 3U);
  // One of them is of no use: the other is.
  EXPECT_EQ(readLog(flasers(541) + flasers(181, 3, "RLASER"), 0, "RLASER").steps.size(), 3U);
}
