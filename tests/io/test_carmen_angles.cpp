// Angles of a CARMEN log's beams: what the log or its user says is used, nothing is invented.
#include "ariadne/io/dataset_writers.h"
#include "carmen_geometry.h"
#include "walled_log.h"

using namespace sample;  // NOLINT: a test of these samples

class CarmenAngles : public CarmenGeometry {};

TEST_F(CarmenAngles, AParamSaysTheAngles) {
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

TEST_F(CarmenAngles, ARearLaserHasParamsOfItsOwn) {
  const std::string params =
      "PARAM laser_front_laser_resolution 0.25\nPARAM laser_rear_laser_resolution 0.5\n";
  expectFan(readLog(params + flasers(541, 3, "RLASER")), -135, 135);
}

TEST_F(CarmenAngles, AParamMayComeAnywhere) {
  const std::string param = "PARAM laser_front_laser_resolution 0.25\n";
  expectFan(readLog(flasers(1081, 2) + param + flasers(1081, 2)), -135, 135);
  const Read late = readLog(flasers(1081, 300) + param);
  EXPECT_EQ(late.steps.size(), 300U);
  expectFan(late, -135, 135);
  const Read unused = readLog(flasers(181, 300) + param);
  expectFan(unused, -90, 90);
  EXPECT_TRUE(unused.warns("resolution 0.25 comes after the first scans and is not used"));
}

TEST_F(CarmenAngles, NoAngleIsGuessed) {
  for (const std::size_t beams : {2, 90, 182, 540, 541, 682, 720, 721, 726, 769, 1080, 1081}) {
    const Read r = readLog(flasers(beams));
    for (const char* part :
         {"a.log: ", "FLASER lines have ", " beams", "field_of_view_deg", "--field-of-view"})
      EXPECT_NE(r.error.find(part), std::string::npos) << beams << ": " << r.error;
    EXPECT_NE(r.error.find(fmt::format("have {} beams", beams)), std::string::npos) << r.error;
  }
}

namespace {

/// What 360 beams see from places along a room of 9 x 6 m, the first `degrees` / 2 to the right.
std::string roomScans(double degrees, const std::string& before = "") {
  std::string text = before;
  for (int k = 0; k < 30; ++k) {
    const TPose2D pose(-3 + 0.2 * k, 0.4, 0.3 + 0.05 * k);
    text += "FLASER 360";
    for (int i = 0; i < 360; ++i)
      text += fmt::format(" {:.2f}",
                          distance(room(9, 6), pose, (i / 360.0 - 0.5) * degrees * M_PI / 180));
    const std::string at = fmt::format("{} {} {}", pose.x, pose.y, pose.phi);
    text += fmt::format(" {0} {0} {1} h 1\n", at, kBegin_s + k);
  }
  return text;
}

}  // namespace

TEST_F(CarmenAngles, ALaserThatLooksAllRoundIsNoSickOf360Beams) {
  expectFan(readLog(roomScans(180)), -90, 89.5);  // as in the logs of Freiburg's building 79
  const Read round = readLog(roomScans(360));
  for (const char* part : {"FLASER lines have 360 beams", "their first and last beams see the same",
                           "field_of_view_deg=360", "--field-of-view"})
    EXPECT_NE(round.error.find(part), std::string::npos) << round.error;
  expectFan(readLog(roomScans(360), 360), -180, 179);
  expectFan(readLog(roomScans(360, "PARAM laser_front_laser_resolution 1.0\n")), -180, 179);
  // From one place a SICK may see the same on both sides.
  expectFan(readLog(flasers(360, 300)), -90, 89.5);
}

TEST_F(CarmenAngles, TheRealLogsLookRoundNowhere) {
  for (const char* name :
       {"mit-csail/mit-csail.clf.gz", "intel/intel-raw910.clf.gz",
        "infinite-corridor/infinite-corridor-corrected.log.gz",
        "large-loops/acapulco-corrected.log.gz", "large-loops/aces-corrected.log.gz"}) {
    if (realLog(name).empty()) GTEST_SKIP() << name << " is missing (set ARIADNE_DATASETS)";
    EXPECT_NO_THROW(io::openDataset(realLog(name))) << name;
  }
}

TEST_F(CarmenAngles, TheUserSaysIt) {
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

TEST_F(CarmenAngles, ParamsThatContradictEachOther) {
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

TEST_F(CarmenAngles, NegativeAnglesAreAClockwiseLaser) {
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

TEST_F(CarmenAngles, ALineWithoutResolutionSaysItByItsField) {
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

TEST_F(CarmenAngles, OddAnglesAreTold) {
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
