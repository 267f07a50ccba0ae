// Each kind of bad input that a dataset can be: a clear error or a counted warning.
#include <sys/resource.h>

#include <algorithm>
#include <limits>

#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

class BadDatasets : public TemporaryFolder {
 protected:
  Result readLog(const std::string& bytes, const std::string& label = "") {
    return readBytes(folder / "a.rawlog", bytes, label);
  }
  void expectError(const std::string& bytes, const std::string& part,
                   const std::string& label = "") {
    const Result r = readLog(bytes, label);
    EXPECT_NE(r.error.find("a.rawlog: "), std::string::npos) << r.error;
    EXPECT_NE(r.error.find(part), std::string::npos) << r.error;
  }
  static long peak_kb() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  }
};

TEST_F(BadDatasets, MissingFolderOrEmpty) {
  EXPECT_NE(read(folder / "none").error.find("none: No such file"), std::string::npos);
  EXPECT_NE(read(folder).error.find("is a directory"), std::string::npos);
  expectError("", "the file is empty");
  expectError(std::string("\x1f\x8b\x08", 3), "");
}

TEST_F(BadDatasets, NotALog) {
  expectError(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
              "neither an MRPT rawlog nor a CARMEN");
  expectError("[section]\nkey = value\n", "no 2D laser scan");
  expectError(std::string(100'000, '\0'), "neither");
}

TEST_F(BadDatasets, NoLaser) {
  expectError(Rawlog().add(action({})).frame({}).add(imu()).bytes(), "no 2D laser scan");
  expectError(Rawlog().add(odometry(kBegin_s, {})).add(imu()).bytes(), "1 CObservationIMU");
  expectError("ODOM 0 0 0 0 0 0 1 h 1\n", "1 ODOM");
}

TEST_F(BadDatasets, NoOdometry) {
  Rawlog log;
  for (int i = 0; i < 2000; ++i) log.add(*scan(kBegin_s + 0.1 * i));
  expectError(log.bytes(), "no odometry");
}

TEST_F(BadDatasets, TwoLasersNeedALabel) {
  Rawlog log;
  for (int i = 0; i < 5; ++i)
    log.add(action({0.1, 0, 0}))
        .frame({scan(kBegin_s + i, "front"), scan(kBegin_s + i, "rear", 9)});
  expectError(log.bytes(), "front (5 scans), rear (5 scans)");
  expectError(log.bytes(), "front (5 scans), rear (5 scans)", "left");
  const Result r = readLog(log.bytes(), "rear");
  EXPECT_EQ(r.steps.size(), 5U) << r.error;
  EXPECT_EQ(r.label, "rear");
  EXPECT_EQ(r.steps[0].scan->getScanSize(), 9U);
  EXPECT_EQ(r.counts.scans_other_lasers, 5U);
}

TEST_F(BadDatasets, TruncatedAnywhere) {
  const std::string whole = pairsLog(12);
  std::size_t most = 0;
  for (std::size_t size = 1; size < whole.size(); size += 7) {
    const Result r = readLog(whole.substr(0, size));
    EXPECT_GE(r.steps.size(), most) << size;  // the more there is, the more is used
    most = std::max(most, r.steps.size());
    if (!r.steps.empty() && size % 11 == 0 && r.warnings.empty()) continue;  // between entries
    EXPECT_TRUE(!r.error.empty() || r.warns("damaged at entry") || r.warnings.empty());
  }
  const Result r = readLog(whole.substr(0, whole.size() - 3));
  EXPECT_EQ(r.steps.size(), 11U);
  EXPECT_TRUE(r.warns("damaged at entry 23, byte")) << r.warnings.at(0);
}

TEST_F(BadDatasets, CorruptedInTheMiddle) {
  std::string bytes = pairsLog(12);
  const std::size_t at = bytes.find("CSensoryFrame", bytes.size() / 2);
  bytes[at] = '\0';
  const Result r = readLog(bytes);
  EXPECT_GE(r.steps.size(), 4U) << r.error;
  EXPECT_TRUE(r.warns("no object where one should begin"));
}

TEST_F(BadDatasets, ClaimsOfFourGigabytesCostNoMemory) {
  const long before_kb = peak_kb();
  for (const std::string& whole : {pairsLog(3), observationsLog(3)})
    for (std::size_t at = 0; at + 4 <= whole.size(); ++at) {
      std::string bytes = whole;
      bytes.replace(at, 4, at % 2 == 0 ? "\xff\xff\xff\xff" : "\xff\xff\xff\x7f");
      readLog(bytes);
    }
  EXPECT_LT(peak_kb() - before_kb, 100'000);
  readLog("FLASER 4294967295 1 2 3\n" + carmenLog(2));
  std::string text = carmenLog(2);
  text.append(5'000'000, ' ').append(5'000'000, '7');
  EXPECT_EQ(readLog(text).steps.size(), 2U);
  EXPECT_LT(peak_kb() - before_kb, 150'000);
}

TEST_F(BadDatasets, BadBeamsAreMarkedAndCounted) {
  auto s = scan(kBegin_s);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const float values[] = {nan, 0, -1, 31, inf, 30, 5};
  for (std::size_t i = 0; i < 7; ++i) s->setScanRange(i, values[i]);
  s->setScanRangeValidity(5, false);
  s->setScanRangeValidity(6, false);
  const Result r = readLog(Rawlog().add(action({})).frame({s}).bytes());
  ASSERT_EQ(r.steps.size(), 1U) << r.error;
  const auto& got = *r.steps[0].scan;
  for (std::size_t i = 0; i < 7; ++i) EXPECT_FALSE(got.getScanRangeValidity(i)) << i;
  for (const std::size_t i : {0U, 1U, 2U, 6U}) EXPECT_EQ(got.getScanRange(i), 0) << i;
  for (const std::size_t i : {3U, 4U, 5U}) EXPECT_GE(got.getScanRange(i), 30) << i;
  EXPECT_TRUE(std::isfinite(got.getScanRange(4)));
  EXPECT_TRUE(got.getScanRangeValidity(7));
  EXPECT_EQ(r.counts.beams, 19U);
  EXPECT_EQ(r.counts.beams_nan, 1U);
  EXPECT_EQ(r.counts.beams_zero, 1U);
  EXPECT_EQ(r.counts.beams_negative, 1U);
  EXPECT_EQ(r.counts.beams_out_of_range, 2U);
  EXPECT_EQ(r.counts.beams_no_return, 1U);
  EXPECT_EQ(r.counts.beams_flagged, 1U);
}

TEST_F(BadDatasets, TimeRunningBackwards) {
  Rawlog log;
  for (const double t : {0.0, 1.0, 2.0, 1.5, 2.0, 3.0, 9999.0, 4.0, 5.0, 6.0})
    log.add(action({0.1, 0, 0})).frame({scan(kBegin_s + t)});
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 8U) << r.error;  // equal stamps are fine; 1.5 and 9999 are not
  for (std::size_t i = 1; i < r.steps.size(); ++i)
    EXPECT_GE(r.steps[i].time_s, r.steps[i - 1].time_s);
  EXPECT_EQ(r.counts.scans_backwards, 2U);
  EXPECT_NEAR(r.steps.back().odom_from_robot.x, 1.0, 1e-9);  // their motion is not lost
}

TEST_F(BadDatasets, OdometryRunningBackwards) {
  Rawlog log;
  const double times[] = {0, 1, 2, 1.5, 5000, 3, 4, 5};
  for (const double t : times) log.add(odometry(kBegin_s + t, {t, 0, 0}));
  for (int i = 0; i < 5; ++i) log.add(*scan(kBegin_s + i + 0.25));
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 5U) << r.error;
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(r.steps[i].odom_from_robot.x, static_cast<double>(i) + 0.25, 1e-5);
  EXPECT_EQ(r.counts.odometry_backwards, 2U);
}

TEST_F(BadDatasets, MissingStampsAreCounted) {
  auto s = scan(kBegin_s);
  s->timestamp = mrpt::Clock::time_point();
  Rawlog log;
  log.add(action({})).frame({scan(kBegin_s)}).add(action({})).frame({s});
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 2U) << r.error;
  EXPECT_EQ(r.steps[1].time_s, r.steps[0].time_s);
  EXPECT_EQ(r.counts.scans_without_stamp, 1U);
}

TEST_F(BadDatasets, TiltedLasersAreSkippedUpsideDownOnesAreNot) {
  Rawlog log;
  const auto add = [&](double yaw, double pitch, double roll) {
    auto s = scan(kBegin_s);
    s->sensorPose = mrpt::poses::CPose3D(0.4, -0.3, 0.2, yaw, pitch, roll);
    log.add(action({})).frame({s});
  };
  add(0.5, 0.05, 0);
  add(0, 0, M_PI);
  add(M_PI, M_PI - 0.01, 0);
  add(0, 0.2, 0);
  add(0, 0, 0.2);
  add(0, M_PI / 2, 0);
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 3U) << r.error;
  EXPECT_EQ(r.counts.scans_not_planar, 3U);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.x(), 0.4, 1e-9);
  EXPECT_NEAR(std::abs(r.steps[1].scan->sensorPose.roll()), M_PI, 1e-6);
}

TEST_F(BadDatasets, ImpossibleGeometryIsSkipped) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Rawlog log;
  const auto add = [&](auto change) {
    auto s = scan(kBegin_s);
    change(*s);
    log.add(action({})).frame({s});
  };
  using Scan = mrpt::obs::CObservation2DRangeScan;
  add([](Scan&) {});
  add([](Scan& s) { s.resizeScan(0); });
  add([](Scan& s) { s.resizeScan(1); });
  add([&](Scan& s) { s.aperture = nan; });
  add([](Scan& s) { s.aperture = 0; });
  add([](Scan& s) { s.sensorPose.x(1e30); });
  add([&](Scan& s) { s.sensorPose.x(nan); });
  add([&](Scan& s) { s.maxRange = nan; });
  add([](Scan& s) { s.maxRange = -3; });
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 3U) << r.error;
  EXPECT_EQ(r.counts.scans_malformed, 6U);
  for (const auto& step : r.steps) EXPECT_GT(step.scan->maxRange, 0);
}

TEST_F(BadDatasets, ImpossibleOdometryIsSkipped) {
  const double nan = std::nan("");
  Rawlog log;
  for (const TPose2D& motion :
       {TPose2D(0.1, 0, 0), TPose2D(nan, 0, 0), TPose2D(1e9, 0, 0), TPose2D(0.1, 0, 0)}) {
    mrpt::obs::CActionRobotMovement2D movement;
    movement.computeFromOdometry({}, {});
    movement.rawOdometryIncrementReading = mrpt::poses::CPose2D(motion);
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    log.add(actions).frame({scan(kBegin_s)});
  }
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 4U) << r.error;
  EXPECT_NEAR(r.steps[3].odom_from_robot.x, 0.2, 1e-9);
  EXPECT_EQ(r.counts.odometry_malformed, 2U);
}

TEST_F(BadDatasets, DamagedCompressionKeepsWhatCameBefore) {
  if (!std::filesystem::exists(kMrptSample)) GTEST_SKIP() << "package mrpt-common is missing";
  std::string packed = io::readWhole(kMrptSample);
  const Result cut = readLog(packed.substr(0, packed.size() / 2));
  EXPECT_GT(cut.steps.size(), 90U) << cut.error;
  EXPECT_TRUE(cut.warns("the compressed data end early"));
  for (std::size_t i = packed.size() / 2; i < packed.size() / 2 + 50; ++i) packed[i] = '\x55';
  const Result damaged = readLog(packed);
  EXPECT_GT(damaged.steps.size(), 80U) << damaged.error;
  EXPECT_TRUE(damaged.warns("damaged"));
}
