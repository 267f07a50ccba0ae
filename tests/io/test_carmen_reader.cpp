#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

class CarmenReader : public TemporaryFolder {
 protected:
  Result readLog(const std::string& text, const std::string& label = "") {
    return readBytes(folder / "a.log", text, label);
  }
  /// Direction of a beam against the robot's heading, degrees.
  static double direction(const ariadne::models::SensorStep& step, std::size_t beam) {
    const auto& s = *step.scan;
    const double first = s.sensorPose.yaw() - s.aperture / 2;
    return (first +
            s.aperture * static_cast<double>(beam) / static_cast<double>(s.getScanSize() - 1)) *
           180 / M_PI;
  }
  const std::string robotlaser =
      "ROBOTLASER1 0 -2.0 4.0 0.5 20 0.01 0 9 1 2 3 4 5 6 7 20 25 2 7 7 {} 0 0 0 0 0 {:.3f} h 1\n";
};

TEST_F(CarmenReader, ReadsPosesRangesAndStamps) {
  const Result r = readLog(carmenLog(10));
  ASSERT_EQ(r.steps.size(), 10U) << r.error;
  EXPECT_EQ(r.label, "FLASER");
  EXPECT_EQ(r.steps[3].odom_from_robot.x, 1.5);
  EXPECT_EQ(r.steps[3].odom_from_robot.phi, 0.1);
  EXPECT_EQ(r.steps[3].time_s, 1500000000.6);
  EXPECT_EQ(r.steps[3].scan->getScanRange(100), 2.5F);
  EXPECT_TRUE(r.warnings.empty());
}

TEST_F(CarmenReader, KnowsTheBeamsOfAFlaserByTheirNumber) {
  struct Case {
    std::size_t beams;
    double first_deg, last_deg;
  };
  for (const Case c : {Case{180, -90, 89}, Case{181, -90, 90}, Case{361, -90, 90},
                       Case{360, -90, 89.5}, Case{401, -50, 50}}) {
    const Result r = readLog(flaser(c.beams, "1", "0 0 0", "0 0 0", kBegin_s));
    ASSERT_EQ(r.steps.size(), 1U) << r.error;
    EXPECT_NEAR(direction(r.steps[0], 0), c.first_deg, 1e-4) << c.beams;
    EXPECT_NEAR(direction(r.steps[0], c.beams - 1), c.last_deg, 1e-4) << c.beams;
  }
}

TEST_F(CarmenReader, TakesARobotlasersAnglesFromItsLine) {
  const Result r = readLog(fmt::format(robotlaser, "1 2 0.3 1 2 0.3", kBegin_s));
  ASSERT_EQ(r.steps.size(), 1U) << r.error;
  EXPECT_NEAR(direction(r.steps[0], 0) * M_PI / 180, -2, 1e-6);
  EXPECT_NEAR(direction(r.steps[0], 8) * M_PI / 180, 2, 1e-6);
  EXPECT_EQ(r.steps[0].scan->maxRange, 20);
  EXPECT_EQ(r.steps[0].odom_from_robot.y, 2);
  EXPECT_EQ(r.counts.beams_no_return, 2U);
  EXPECT_GE(r.steps[0].scan->getScanRange(7), 20);
  EXPECT_FALSE(r.steps[0].scan->getScanRangeValidity(7));
}

TEST_F(CarmenReader, NoReturnIsNotGarbage) {
  for (const char* nothing : {"81.9", "81.91", "81.83", "80", "inf"}) {
    const Result r = readLog(flaser(181, nothing, "0 0 0", "0 0 0", kBegin_s));
    ASSERT_EQ(r.steps.size(), 1U) << r.error;
    EXPECT_EQ(r.counts.beams_no_return, 181U) << nothing;
    EXPECT_GE(r.steps[0].scan->getScanRange(5), r.steps[0].scan->maxRange);
    EXPECT_FALSE(r.steps[0].scan->getScanRangeValidity(5));
  }
  for (const char* garbage : {"0", "-1", "nan"}) {
    const Result r = readLog(flaser(181, garbage, "0 0 0", "0 0 0", kBegin_s));
    ASSERT_EQ(r.steps.size(), 1U) << r.error;
    EXPECT_EQ(r.counts.beams_no_return, 0U) << garbage;
    EXPECT_EQ(r.steps[0].scan->getScanRange(5), 0);
    EXPECT_FALSE(r.steps[0].scan->getScanRangeValidity(5));
  }
}

TEST_F(CarmenReader, FindsWhereTheLaserSits) {
  std::string text;
  for (int i = 0; i < 20; ++i) {  // the robot turns, the laser is 0.3 m ahead of its centre
    const double phi = 0.3 * i;
    text += flaser(181, "1",
                   fmt::format("{:.3f} {:.3f} {:.3f}", 5 + 0.3 * std::cos(phi),
                               1 + 0.3 * std::sin(phi), std::remainder(phi, 2 * M_PI)),
                   fmt::format("5 1 {:.3f}", std::remainder(phi, 2 * M_PI)), kBegin_s + i);
  }
  const Result r = readLog(text);
  ASSERT_EQ(r.steps.size(), 20U) << r.error;
  EXPECT_NEAR(r.steps[7].scan->sensorPose.x(), 0.3, 2e-3);
  EXPECT_NEAR(r.steps[7].scan->sensorPose.y(), 0, 2e-3);
  EXPECT_EQ(r.steps[7].odom_from_robot.x, 5);
}

TEST_F(CarmenReader, ACorrectedLaserPoseIsNoOffset) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += flaser(181, "1", fmt::format("{} {} 0", i, 0.1 * i), fmt::format("{} 0 0", i),
                   kBegin_s + i);
  const Result r = readLog(text);
  ASSERT_EQ(r.steps.size(), 20U) << r.error;
  EXPECT_EQ(r.steps[9].scan->sensorPose.y(), 0);
  EXPECT_TRUE(r.warns("no constant offset"));
}

TEST_F(CarmenReader, PrefersRobotlaserToTheFlaserThatRepeatsIt) {
  std::string text;
  for (int i = 0; i < 5; ++i) {
    text += fmt::format(robotlaser, "0 0 0 0 0 0", kBegin_s + i);
    text += flaser(181, "1", "0 0 0", "0 0 0", kBegin_s + i);
  }
  const Result r = readLog(text);
  EXPECT_EQ(r.steps.size(), 5U) << r.error;
  EXPECT_EQ(r.label, "ROBOTLASER1");
}

TEST_F(CarmenReader, SkipsMalformedLinesAndNamesTheFirst) {
  const std::string log = carmenLog(5) + "FLASER 181 1 2\nFLASER x\nFLASER -1\nFLASER\n" +
                          "FLASER 4000000000 1\nROBOTLASER1 0 nan\n";
  const Result r = readLog(log);
  EXPECT_EQ(r.steps.size(), 5U) << r.error;
  EXPECT_EQ(r.counts.lines_malformed, 6U);
  EXPECT_TRUE(r.warns("a.log:13: number of ranges '181'")) << r.warnings[0];
  const Result none = readLog("# CARMEN\nFLASER 181 1 2\n");
  EXPECT_NE(none.error.find("a.log:2: number of ranges"), std::string::npos) << none.error;
}

TEST_F(CarmenReader, ReadsTheRealLogs) {
  const auto csail = realLog("mit-csail/mit-csail.clf.gz");
  if (csail.empty()) GTEST_SKIP() << "mit-csail.clf.gz is missing (set ARIADNE_DATASETS)";
  const Result r = read(csail);
  EXPECT_EQ(r.steps.size(), 1988U);
  EXPECT_EQ(r.counts.beams, 1988U * 361);
  EXPECT_TRUE(r.warnings.empty());
  EXPECT_NEAR(r.steps.back().time_s - r.steps.front().time_s, 424, 0.1);
}
