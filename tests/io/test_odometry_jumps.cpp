// Odometry that is reset, in each of the ways that a log has odometry.
#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

class OdometryJumps : public TemporaryFolder {
 protected:
  static std::vector<std::size_t> jumpsOf(const Result& r) {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < r.steps.size(); ++i)
      if (r.steps[i].odometry_jumped) at.push_back(i);
    return at;
  }
};

namespace {

/// 1 m/s ahead from (5, 2); from 4 s on counted from (0, 0, 0).
TPose2D resetAt4s(double time_s) {
  return time_s < 4 ? TPose2D(5 + time_s, 2, 0.5) : TPose2D(time_s - 4, 0, 0);
}

}  // namespace

TEST_F(OdometryJumps, OnLines) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    const auto p = resetAt4s(0.2 * i);
    const std::string pose = fmt::format("{} {} {}", p.x, p.y, p.phi);
    text += flaser(181, "2.5", pose, pose, kBegin_s + 0.2 * i);
  }
  const Result r = readBytes(folder / "a.log", text);
  EXPECT_EQ(jumpsOf(r), std::vector<std::size_t>{20});
  const auto& jumps = r.counts.odometry_jumps;
  EXPECT_EQ(jumps.count, 1U);
  EXPECT_EQ(jumps.scan, 21U);
  EXPECT_NEAR(jumps.time_s, kBegin_s + 4, 1e-6);
  EXPECT_NEAR(jumps.distance_m, std::hypot(8.8, 2), 1e-6);
  EXPECT_NEAR(jumps.span_s, 0.2, 1e-6);
  EXPECT_NEAR(r.steps[20].odom_from_robot.x, 0, 1e-6);  // as recorded
  EXPECT_TRUE(r.warns("jumped 1 times, first by 9.02 m and 29 degrees in 0.200 s to scan 21"));
  EXPECT_EQ(r.warnings.size(), 1U);
}

TEST_F(OdometryJumps, OfIncrements) {
  Rawlog log;
  for (int i = 0; i < 30; ++i)
    log.add(action(i == 12 ? TPose2D(-8, 2, 3) : TPose2D(0.1, 0, 0))).frame({scan(0.2 * i + 1)});
  EXPECT_EQ(jumpsOf(readBytes(folder / "a.rawlog", log.bytes())), std::vector<std::size_t>{12});
}

TEST_F(OdometryJumps, NoScanIsBetweenTheReadingsOfAJump) {
  Rawlog log;
  for (int i = 0; i < 100; ++i) {
    log.add(odometry(kBegin_s + 0.1 * i, resetAt4s(0.1 * i)));
    if (i < 99) log.add(*scan(kBegin_s + 0.1 * i + 0.03));
    if (i < 99) log.add(*scan(kBegin_s + 0.1 * i + 0.07));
  }
  const Result r = readBytes(folder / "a.rawlog", log.bytes());
  ASSERT_EQ(r.steps.size(), 198U) << r.error;
  EXPECT_EQ(jumpsOf(r), std::vector<std::size_t>{79});  // at 3.97 s: nearer to the reset one
  EXPECT_NEAR(r.steps[78].odom_from_robot.x, 8.9, 1e-6);
  EXPECT_NEAR(r.steps[79].odom_from_robot.x, 0, 1e-6);
  EXPECT_NEAR(r.steps[80].odom_from_robot.x, 0.03, 1e-5);
}

TEST_F(OdometryJumps, AreNotLookedForWithoutOdometry) {
  std::string text;
  for (int i = 0; i < 10; ++i) {
    const std::string pose = i == 5 ? "100 0 0" : "1 0 0";
    text += flaser(181, "2.5", pose, pose, kBegin_s + 0.2 * i);
  }
  io::writeWhole(folder / "a.log", text);
  io::DatasetOptions options;
  options.use_odometry = false;
  const auto source = io::openDataset(folder / "a.log", options);
  std::size_t steps = 0;
  while (const auto step = source->next()) {
    ++steps;
    EXPECT_EQ(step->odom_from_robot, TPose2D());
  }
  EXPECT_EQ(steps, 10U);
  EXPECT_EQ(source->counts().odometry_jumps.count, 0U);
}

TEST_F(OdometryJumps, ALogOfScansAloneCanBeReadWithoutOdometry) {
  Rawlog log;
  for (int i = 0; i < 5; ++i) log.add(*scan(kBegin_s + i));
  io::writeWhole(folder / "a.rawlog", log.bytes());
  io::DatasetOptions options;
  options.use_odometry = false;
  const auto source = io::openDataset(folder / "a.rawlog", options);
  std::size_t steps = 0;
  while (source->next()) ++steps;
  EXPECT_EQ(steps, 5U);
}

// None in the real logs (their raw odometry has steps of 0.95 m and 86 degrees in 0.21 s).
TEST_F(OdometryJumps, NoneInRealLogs) {
  std::size_t found = 0;
  for (const char* name :
       {"mit-csail/mit-csail.clf.gz", "intel/intel-raw910.clf.gz", "intel/mrpt-intel.rawlog",
        "intel/intel-corrected910.clf.gz", "mit-csail/csail-corrected.log.gz",
        "infinite-corridor/infinite-corridor-corrected.log.gz",
        "large-loops/acapulco-corrected.log.gz", "large-loops/aces-corrected.log.gz"}) {
    const auto log = realLog(name);
    if (log.empty()) continue;
    ++found;
    EXPECT_EQ(read(log).counts.odometry_jumps.count, 0U) << name;
  }
  if (std::filesystem::exists(kMrptSample)) {
    ++found;
    EXPECT_EQ(read(kMrptSample).counts.odometry_jumps.count, 0U);
  }
  if (found == 0) GTEST_SKIP() << "no real log is here";
}
