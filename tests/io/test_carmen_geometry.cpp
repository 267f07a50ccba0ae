// Angles of a CARMEN log's beams: what the log or its user says is used, nothing is invented.
#include "ariadne/io/dataset_records.h"
#include "ariadne/io/dataset_writers.h"
#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

class CarmenGeometry : public TemporaryFolder {
 protected:
  struct Read : Result {
    std::vector<std::string> notes;
    bool notesThat(const std::string& part) const {
      for (const std::string& n : notes)
        if (n.find(part) != n.npos) return true;
      return false;
    }
  };
  Read readLog(const std::string& text, double field_of_view_deg = 0,
               const std::string& label = "") {
    io::writeWhole(folder / "a.log", text);
    Read r;
    io::DatasetOptions options;
    options.field_of_view_deg = field_of_view_deg;
    options.laser_label = label;
    try {
      const auto source = io::openDataset(folder / "a.log", options);
      while (auto step = source->next()) r.steps.push_back(std::move(*step));
      r.counts = source->counts();
      r.warnings = source->warnings();
      r.label = source->laserLabel();
      const auto records = io::openRecords(folder / "a.log", options);
      while (records->next()) continue;
      r.notes = records->notes();
    } catch (const ariadne::core::Error& e) {
      r.error = e.what();
    }
    return r;
  }

  /// Directions of the first and the last beam from the robot's axis, degrees. The tolerance is
  /// what a resolution in radians of seven digits loses over 1081 beams.
  static void expectFan(const Read& r, double first_deg, double last_deg) {
    ASSERT_FALSE(r.steps.empty()) << r.error;
    const auto& s = *r.steps[0].scan;
    const double side = s.rightToLeft ? 1 : -1;
    const double middle = s.sensorPose.yaw() * 180 / M_PI;
    const double half = s.aperture / 2 * 180 / M_PI;
    EXPECT_NEAR(std::remainder(middle - side * half - first_deg, 360), 0, 2e-3);
    EXPECT_NEAR(std::remainder(middle + side * half - last_deg, 360), 0, 2e-3);
    EXPECT_NEAR(2 * half, std::abs(last_deg - first_deg), 2e-3);
  }

  static std::string flasers(std::size_t beams, int lines = 3, const char* kind = "FLASER") {
    std::string text;
    for (int i = 0; i < lines; ++i)
      text += kind + flaser(beams, "2.5", "1 2 0", "1 2 0", kBegin_s + i).substr(6);
    return text;
  }

  /// A ROBOTLASER1 line with these angles, as they stand in the line.
  static std::string robotlaser(const std::string& angles, std::size_t beams, double time_s,
                                const char* kind = "ROBOTLASER1") {
    std::string line = fmt::format("{} 0 {} 30 0.01 0 {}", kind, angles, beams);
    for (std::size_t i = 0; i < beams; ++i) line += fmt::format(" {:.3f}", 1 + 0.01 * double(i));
    line += " 0 ";
    if (std::string(kind).rfind("RAW", 0) != 0) line += "1 2 0.5 1 2 0.5 0 0 0 0 0 ";
    return line + fmt::format("{:.6f} host {:.6f}\n", time_s, time_s - kBegin_s);
  }
};

TEST_F(CarmenGeometry, AParamSaysTheAngles) {
  struct Case {
    const char* param;
    std::size_t beams;
    double first, last;
  };
  for (const Case c : {Case{"laser_front_laser_resolution 0.25", 1081, -135, 135},
                       {"laser_frontlaser_resolution 0.25", 1080, -135, 134.75},
                       {"laser_front_laser_resolution 0.5", 541, -135, 135},
                       {"laser_laser1_resolution 0.25", 721, -90, 90},
                       {"laser_front_laser_resolution 0.5", 721, -180, 180},
                       {"laser_front_laser_resolution 0.0043633", 1081, -135, 135},
                       {"laser_front_laser_resolution 1.0", 360, -180, 179},
                       {"laser_front_laser_resolution 0.5", 361, -90, 90},
                       {"laser_front_laser_resolution 0.3515625", 683, -119.8828, 119.8828},
                       {"laser_front_laser_resolution -0.25", 1081, 135, -135},
                       {"laser_front_laser_fov 270", 1081, -135, 135},
                       {"laser_frontlaser_fov 4.712389", 541, -135, 135},
                       {"laser_laser1_fov 360", 720, -180, 179.5},
                       {"laser_front_laser_fov 190", 381, -95, 95}}) {
    SCOPED_TRACE(fmt::format("{} and {} beams", c.param, c.beams));
    const Read r = readLog(fmt::format("PARAM {} 1.5 host 1.5\n", c.param) + flasers(c.beams));
    EXPECT_EQ(r.steps.size(), 3U);
    expectFan(r, c.first, c.last);
    EXPECT_TRUE(r.warnings.empty());
    EXPECT_TRUE(r.notesThat(std::string("by PARAM ") + c.param)) << r.notes.at(0);
  }
}

TEST_F(CarmenGeometry, ARearLaserHasParamsOfItsOwn) {
  const std::string params =
      "PARAM laser_front_laser_resolution 0.25\nPARAM laser_rear_laser_resolution 0.5\n";
  expectFan(readLog(params + flasers(541, 3, "RLASER")), -135, 135);
}

TEST_F(CarmenGeometry, AParamMayComeAnywhere) {
  const std::string param = "PARAM laser_front_laser_resolution 0.25\n";
  expectFan(readLog(flasers(1081, 2) + param + flasers(1081, 2)), -135, 135);
  const Read late = readLog(flasers(1081, 300) + param);
  EXPECT_EQ(late.steps.size(), 300U);
  expectFan(late, -135, 135);
  const Read unused = readLog(flasers(181, 300) + param);
  expectFan(unused, -90, 90);
  EXPECT_TRUE(unused.warns("resolution 0.25 comes after the first scans and is not used"));
}

TEST_F(CarmenGeometry, NoAngleIsGuessed) {
  for (const std::size_t beams : {2, 90, 182, 540, 541, 682, 720, 721, 726, 769, 1080, 1081}) {
    const Read r = readLog(flasers(beams));
    for (const char* part :
         {"a.log: ", "FLASER lines have ", " beams", "field_of_view_deg", "--field-of-view"})
      EXPECT_NE(r.error.find(part), std::string::npos) << beams << ": " << r.error;
    EXPECT_NE(r.error.find(fmt::format("have {} beams", beams)), std::string::npos) << r.error;
  }
}

TEST_F(CarmenGeometry, TheUserSaysIt) {
  expectFan(readLog(flasers(541), 270), -135, 135);
  expectFan(readLog(flasers(1080), 270), -135, 134.75);
  expectFan(readLog(flasers(360), 360), -180, 179);
  EXPECT_TRUE(readLog(flasers(541), 270).warnings.empty());
  // Against PARAM and the lines' own angles, and told.
  const Read r = readLog("PARAM laser_front_laser_resolution 0.25\n" + flasers(541), 270);
  expectFan(r, -135, 135);
  EXPECT_TRUE(r.warns("270 degrees by field_of_view_deg = 270 are used, not 135 degrees by PARAM"));
  const Read own = readLog(robotlaser("1.570796 -3.141593 -0.017453", 181, kBegin_s), 90);
  expectFan(own, 45, -45);
  EXPECT_TRUE(own.warns("not 180 degrees by its lines"));
}

TEST_F(CarmenGeometry, ParamsThatContradictEachOther) {
  const std::string one_degree = "PARAM laser_front_laser_resolution 1.0\n";
  const std::string half_turn = "PARAM laser_front_laser_fov 180\n";
  // The number of beams is a SICK's, and one of the two fits it.
  const Read told = readLog(one_degree + half_turn + flasers(361));
  expectFan(told, -90, 90);
  EXPECT_TRUE(told.warns("contradict each other"));
  const Read none = readLog("PARAM laser_front_laser_resolution 0.25\n" + half_turn + flasers(541));
  EXPECT_NE(none.error.find("contradict each other with 541 beams"), std::string::npos)
      << none.error;
  const Read impossible = readLog(one_degree + flasers(541));
  EXPECT_NE(impossible.error.find("resolution 1.0 is not possible with 541 beams"),
            std::string::npos)
      << impossible.error;
  const Read stale = readLog(one_degree + "PARAM laser_front_laser_fov 270\n" + flasers(541));
  expectFan(stale, -135, 135);
  EXPECT_TRUE(stale.warns("not possible"));
  // Both, and they agree.
  const Read both = readLog(
      "PARAM laser_front_laser_resolution 0.5\n"
      "PARAM laser_front_laser_fov 3.14159\n" +
      flasers(361));
  expectFan(both, -90, 90);
  EXPECT_TRUE(both.warnings.empty());
}

TEST_F(CarmenGeometry, NegativeAnglesAreAClockwiseLaser) {
  struct Case {
    const char* angles;
    std::size_t beams;
    double first, last;
  };
  for (const Case c : {Case{"1.570796 -3.141593 -0.01745329", 181, 90, -90},
                       {"2.356194 -4.712389 -0.004363323", 1081, 135, -135},
                       {"1.2 -2.094395 -0.01745329", 121, 68.7549, -51.2451},
                       {"3.141593 -6.265732 -0.01745329", 360, 180, -179},
                       {"1.570796 -3.141593 0", 181, 90, -90},
                       {"0 -3.141593 0", 181, 90, -90}}) {
    SCOPED_TRACE(c.angles);
    const Read r = readLog(robotlaser(c.angles, c.beams, kBegin_s));
    ASSERT_EQ(r.steps.size(), 1U) << r.error;
    EXPECT_TRUE(r.warnings.empty());
    const auto& s = *r.steps[0].scan;
    EXPECT_FALSE(s.rightToLeft);
    expectFan(r, c.first, c.last);
  }
  // Exported, its beams are turned round: 2.8 m is right ahead and 1 m left of it either way.
  readLog(robotlaser("1.570796 -3.141593 -0.01745329", 181, kBegin_s));
  const auto source = io::openDataset(folder / "a.log");
  io::writeCarmen(folder / "b.log", [&] { return source->next(); });
  const auto step = io::openDataset(folder / "b.log")->next();
  ASSERT_TRUE(step);
  EXPECT_TRUE(step->scan->rightToLeft);
  EXPECT_NEAR(step->scan->getScanRange(180), 1, 1e-6);
  EXPECT_NEAR(step->scan->getScanRange(0), 2.8, 1e-6);
}

TEST_F(CarmenGeometry, ALineWithoutResolutionSaysItByItsField) {
  expectFan(readLog(robotlaser("-1.570796 3.141593 0", 181, kBegin_s)), -90, 90);
  expectFan(readLog(robotlaser("-1.570796 3.141593 0", 180, kBegin_s)), -90, 89);
  expectFan(readLog(robotlaser("-1.570796 3.124139 0", 180, kBegin_s)), -90, 89);
  expectFan(readLog(robotlaser("-1.570796 3.141593 inf", 361, kBegin_s)), -90, 90);
  expectFan(readLog(robotlaser("-2.356194 4.712389 0", 1081, kBegin_s)), -135, 135);
  // Nothing but zeros: as with FLASER.
  expectFan(readLog(robotlaser("0 0 0", 181, kBegin_s)), -90, 90);
  expectFan(
      readLog("PARAM laser_front_laser_resolution 0.25\n" + robotlaser("0 0 0", 1081, kBegin_s)),
      -135, 135);
  EXPECT_NE(readLog(robotlaser("0 0 0", 1081, kBegin_s)).error.find("field_of_view_deg"),
            std::string::npos);
}

TEST_F(CarmenGeometry, OddAnglesAreTold) {
  const Read degrees = readLog(robotlaser("-90 180 1", 181, kBegin_s));
  expectFan(degrees, -90, 90);
  EXPECT_TRUE(degrees.warns("taken for degrees"));
  const Read start = readLog(robotlaser("-1.570796 3.141593 0.00873", 181, kBegin_s));
  expectFan(start, -90, 90);  // the start fits the field of view
  EXPECT_TRUE(start.warns("the field of view is used"));
  const Read step = readLog(robotlaser("-0.785398 3.141593 0.00872665", 181, kBegin_s));
  expectFan(step, -45, 45);  // here it fits the resolution
  EXPECT_TRUE(step.warns("the resolution is used"));
  const Read signs = readLog(robotlaser("1.570796 -3.141593 0.01745329", 181, kBegin_s));
  expectFan(signs, 90, -90);
  EXPECT_TRUE(signs.warns("taken for clockwise"));
  const Read impossible = readLog(robotlaser("1e6 0 1", 181, kBegin_s));
  expectFan(impossible, -90, 90);
  EXPECT_TRUE(impossible.warns("are impossible"));
}

TEST_F(CarmenGeometry, ParamsSayWhereALaserSitsWhenItsLinesDoNot) {
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

TEST_F(CarmenGeometry, LinesThatAgreeOnAnOffsetWin) {
  std::string text = "PARAM robot_frontlaser_offset 0.6\n";
  for (int i = 0; i < 20; ++i)
    text +=
        flaser(181, "1", fmt::format("{} 2 0", i + 0.3), fmt::format("{} 2 0", i), kBegin_s + i);
  const Read r = readLog(text);
  ASSERT_EQ(r.steps.size(), 20U) << r.error;
  EXPECT_NEAR(r.steps[9].scan->sensorPose.x(), 0.3, 1e-6);
  EXPECT_TRUE(r.warns("PARAM robot_frontlaser_offset 0.6 is not used"));
}

TEST_F(CarmenGeometry, AParamsMaximumRangeIsBelievedWhenReadingsKeepIt) {
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

TEST_F(CarmenGeometry, RawLasersTakeTheirPosesFromOdometry) {
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

TEST_F(CarmenGeometry, LinesWithPosesAreUsedWhereThereAreSuch) {
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

TEST_F(CarmenGeometry, OldLinesLackARemissionModeAndATurningAxis) {
  const std::string old = fmt::format(
      "ROBOTLASER1 0 -1 2 0.5 20 0.01 5 1 2 3 4 5 0 1.5 2 0 1 2 0 0 0 0 0 {:.3f} h 1\n", kBegin_s);
  const Read r = readLog(old);
  ASSERT_EQ(r.steps.size(), 1U) << r.error;
  EXPECT_EQ(r.steps[0].time_s, kBegin_s);
  EXPECT_EQ(r.steps[0].scan->getScanRange(4), 5);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.x(), 0.5, 1e-6);
}

TEST_F(CarmenGeometry, TwoLasersNeedAChoiceAndTheErrorSaysHow) {
  const Read r = readLog(flasers(181) + flasers(181, 3, "RLASER"));
  for (const char* part : {"FLASER (3 scans), RLASER (3 scans)", "laser_label", "--laser"})
    EXPECT_NE(r.error.find(part), std::string::npos) << r.error;
  EXPECT_EQ(readLog(flasers(181) + flasers(181, 3, "RLASER"), 0, "RLASER").steps.size(), 3U);
  // One of them is of no use: the other is.
  EXPECT_EQ(readLog(flasers(541) + flasers(181, 3, "RLASER"), 0, "RLASER").steps.size(), 3U);
}
