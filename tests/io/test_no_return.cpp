// What means "nothing there", and that walls do not.
#include "temporary_folder.h"
#include "walled_log.h"

using namespace sample;  // NOLINT: a test of these samples

class NoReturn : public TemporaryFolder {
 protected:
  Result readLog(const std::string& text, const io::DatasetOptions& options = {}) {
    io::writeWhole(folder / "a.log", text);
    return read(folder / "a.log", options);
  }
  /// Of what a laser sees in these walls nothing may be lost.
  void expectWallsOnly(const Walls& walls, const std::vector<TPose2D>& poses, Laser laser) {
    for (const auto& [rounding_m, noise_m] :
         {std::pair(0.001, 0.0), std::pair(0.05, 0.0), std::pair(0.01, 0.01)}) {
      laser.rounding_m = rounding_m;
      laser.noise_m = noise_m;
      const Result r = readLog(walledLog(walls, poses, laser));
      ASSERT_EQ(r.steps.size(), poses.size()) << r.error;
      EXPECT_EQ(r.counts.beams_over_reach, 0U)
          << rounding_m << " " << noise_m << " from " << r.counts.no_return_from_m;
      EXPECT_TRUE(r.warnings.empty()) << r.warnings[0];
    }
  }
  /// A hall with four pillars, larger than the reach of most lasers.
  static Walls hall() {
    Walls walls = room(40, 30);
    for (const double x : {-9.0, 8.0})
      for (const double y : {-6.0, 7.0})
        for (const Wall& w : room(1, 1.4))
          walls.push_back({w.x0 + x, w.y0 + y, w.x1 + x, w.y1 + y});
    return walls;
  }
  static std::vector<TPose2D> roundTheHall() {
    return driveAlong({{-14, -10}, {13, -11}, {15, 3}, {12, 11}, {-13, 10.5}, {-15, 0}, {-2, 1}});
  }
};

TEST_F(NoReturn, CodesOfRealLogsAreRecognised) {
  struct Case {
    double reach_m;
    std::vector<float> nothing;
    double from_m;
  };
  for (const Case& c :
       {Case{8, {8.183F}, 8.183}, Case{8, {8.191F}, 8.191}, Case{8, {8.187F, 8.183F}, 8.183},
        Case{9.9, {9.99F}, 9.99}, Case{16, {16.383F}, 16.383}, Case{18, {32.76F}, 32.76},
        Case{18, {32.77F, 32.76F}, 32.76}, Case{18, {29.99F}, 29.99}, Case{18, {30.01F, 30.0F}, 30},
        Case{18, {50.0F}, 50}, Case{18, {51.15F}, 51.15}, Case{18, {51.15F, 51.14F, 50.0F}, 50},
        Case{5.5, {5.6F}, 5.6}})
    for (const double rounding_m : {0.001, 0.05}) {
      Laser laser;
      laser.reach_m = c.reach_m;
      laser.nothing = c.nothing;
      laser.rounding_m = rounding_m;
      laser.noise_m = 0.01;
      const auto poses = roundTheHall();
      const Result r = readLog(walledLog(hall(), poses, laser));
      ASSERT_EQ(r.steps.size(), poses.size()) << r.error;
      EXPECT_NEAR(r.counts.no_return_from_m, c.from_m, 1e-6) << c.nothing[0];
      EXPECT_EQ(r.counts.no_return_codes_mm.size(), c.nothing.size()) << c.nothing[0];
      EXPECT_EQ(r.counts.beams_no_return, r.counts.beams_over_reach);
      EXPECT_GT(r.counts.beams_over_reach, r.counts.beams / 200);
      EXPECT_EQ(r.counts.no_return_from_step, 0U);
      EXPECT_TRUE(r.warns("are taken for no return")) << c.nothing[0];
      for (const auto& step : r.steps)
        for (std::size_t i = 0; i < step.scan->getScanSize(); ++i) {
          const bool wall = step.scan->getScanRange(i) < c.from_m - 1e-3;
          ASSERT_EQ(step.scan->getScanRangeValidity(i), wall);
          ASSERT_TRUE(wall || step.scan->getScanRange(i) >= step.scan->maxRange);
        }
    }
}

TEST_F(NoReturn, AScanOfNothingElseIsNoCircularWall) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const std::string pose = fmt::format("{} 0 0", 0.15 * i);
    text += flaser(181, "8.183", pose, pose, kBegin_s + i);
  }
  const Result r = readLog(text);
  EXPECT_EQ(r.counts.beams_no_return, 3U * 181);
}

TEST_F(NoReturn, ARobotThatStandsSeesNoCode) {
  std::vector<TPose2D> poses(400, TPose2D(0.3, 0.2, 0.1));
  expectWallsOnly(room(12, 9), poses, {});
  poses.assign(400, TPose2D(0, 0, 0));  // the end of a corridor 30 m away, straight ahead
  expectWallsOnly({{-5, 1, 30, 1}, {30, 1, 30, -1}, {30, -1, -5, -1}}, poses, {});
}

TEST_F(NoReturn, ARobotThatTurnsOnTheSpotSeesNoCode) {
  std::vector<TPose2D> poses;
  for (int i = 0; i < 400; ++i) poses.emplace_back(0, 0, 0.1 * i);
  expectWallsOnly(room(12, 12), poses, {});
  expectWallsOnly({{-30, 1, 30, 1}, {30, 1, 30, -1}, {30, -1, -30, -1}}, poses, {});
}

TEST_F(NoReturn, WallsOfARoomAreNoCodeWhereverTheRobotIs) {
  const auto poses = driveAlong({{-4, -3}, {4, -3}, {4, 3}, {-4, 3}, {-4, -3}, {4, 3}});
  expectWallsOnly(room(12, 9), poses, {});
  expectWallsOnly(hall(), roundTheHall(), {});
}

TEST_F(NoReturn, ACorridorsEndIsNoCodeFromStandingOrDrivingToIt) {
  std::vector<TPose2D> poses(300, TPose2D(0, 0, 0));
  for (const TPose2D& pose : driveAlong({{0, 0}, {38, 0}})) poses.push_back(pose);
  poses.insert(poses.end(), 300, TPose2D(38, 0, 0));
  expectWallsOnly({{-2, 1, 40, 1}, {40, 1, 40, -1}, {40, -1, -2, -1}}, poses, {});
}

/// The beams at 4 degrees from straight ahead see the wall at the same range all along: they are
/// the longest that a laser of 19.15 m has in straight corridors about a block, in four directions.
TEST_F(NoReturn, ACorridorsSideIsNoCodeAllAlong) {
  Laser laser;
  laser.reach_m = 19.15;
  Walls walls = room(62, 42);
  for (const Wall& w : room(58, 38)) walls.push_back(w);
  for (int i = 0; i < 9; ++i) {  // niches, so that not all scans are alike
    const double x = -25 + 5.3 * i;
    walls.push_back({x, -19, x + 0.8, -19.4});
    walls.push_back({x, 20.6, x + 0.5, 21});
  }
  const auto poses = driveAlong({{-30, -20}, {30, -20}, {30, 20}, {-30, 20}, {-30, -20}, {0, -20}});
  expectWallsOnly(walls, poses, laser);
}

TEST_F(NoReturn, LapsOverTheSamePlacesMakeNoCode) {
  std::vector<Corner> corners;
  for (int lap = 0; lap < 12; ++lap)
    for (const Corner& corner : {Corner{-4, -3}, Corner{4, -3}, Corner{4, 3}, Corner{-4, 3}})
      corners.push_back(corner);
  expectWallsOnly(room(12, 9), driveAlong(corners), {});
}

TEST_F(NoReturn, IsRecognisedWhereOdometryStaysAtZero) {
  Laser laser;
  laser.reach_m = 18;
  laser.nothing = {51.15F};
  laser.odometry = false;
  const Result r = readLog(walledLog(hall(), roundTheHall(), laser));
  EXPECT_NEAR(r.counts.no_return_from_m, 51.15, 1e-6);
}

TEST_F(NoReturn, ACodeThatComesLateIsToldWithTheScanWhereItBegins) {
  Laser laser;
  laser.reach_m = 18;
  laser.nothing = {32.77F};
  const std::size_t standing = 2300;
  std::string log = walledLog(room(12, 9), std::vector<TPose2D>(standing), laser);
  Laser later = laser;
  later.begin_s += 1000;
  log += walledLog(hall(), roundTheHall(), later);
  const Result r = readLog(log);
  ASSERT_GT(r.steps.size(), standing) << r.error;
  EXPECT_NEAR(r.counts.no_return_from_m, 32.77, 1e-6);
  EXPECT_GT(r.counts.no_return_from_step, 0U);
  EXPECT_LT(r.counts.no_return_from_step, standing) << "what lies ahead is looked at";
  EXPECT_TRUE(r.warns(fmt::format("from scan {} on", r.counts.no_return_from_step + 1)));
}

TEST_F(NoReturn, ALimitThatIsSetIsTheLimit) {
  auto s = scan(kBegin_s);
  const float values[] = {9.9F, 10, 12, 29, 31, 81.91F};
  for (std::size_t i = 0; i < 6; ++i) s->setScanRange(i, values[i]);
  s->setScanRangeValidity(4, false);
  s->setScanRangeValidity(5, false);
  const std::string log = Rawlog().add(action({})).frame({s}).bytes();
  io::DatasetOptions options;
  options.max_range_m = 10;
  const Result near = readLog(log, options);
  ASSERT_EQ(near.steps.size(), 1U) << near.error;
  EXPECT_TRUE(near.steps[0].scan->getScanRangeValidity(0));
  for (std::size_t i = 1; i < 6; ++i) EXPECT_FALSE(near.steps[0].scan->getScanRangeValidity(i));
  EXPECT_EQ(near.counts.beams_no_return, 5U);
  EXPECT_EQ(near.counts.beams_over_reach, 3U) << "the file's own maximum is 30";
  EXPECT_TRUE(near.warns("3 beams of 10 m or more are taken for no return, as max_range_m says"));
  options.max_range_m = 50;  // more than the file says
  const Result far = readLog(log, options);
  EXPECT_TRUE(far.steps[0].scan->getScanRangeValidity(4));
  EXPECT_EQ(far.steps[0].scan->getScanRange(4), 31);
  EXPECT_FALSE(far.steps[0].scan->getScanRangeValidity(5));
  EXPECT_EQ(far.counts.beams_no_return, 1U);
}

TEST_F(NoReturn, WhatIsTooNearIsLeftOutAndCounted) {
  auto s = scan(kBegin_s);
  const float values[] = {0.001F, 0.019F, 0.029F, 0.03F, 0.05F};
  for (std::size_t i = 0; i < 5; ++i) s->setScanRange(i, values[i]);
  const std::string log = Rawlog().add(action({})).frame({s}).bytes();
  const Result r = readLog(log);
  ASSERT_EQ(r.steps.size(), 1U) << r.error;
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(r.steps[0].scan->getScanRangeValidity(i), i >= 3) << i;
    EXPECT_EQ(r.steps[0].scan->getScanRange(i), i >= 3 ? values[i] : 0) << i;
  }
  EXPECT_EQ(r.counts.beams_too_near, 3U);
  EXPECT_TRUE(r.warns("3 beams are nearer than [dataset] min_range_m"));
  io::DatasetOptions options;
  options.min_range_m = 0;
  EXPECT_EQ(readLog(log, options).counts.beams_too_near, 0U);
  options.min_range_m = 0.04;
  EXPECT_EQ(readLog(log, options).counts.beams_too_near, 4U);
}

TEST_F(NoReturn, TheSharedCases) {
  if (sharedCase("m02_code.log").empty()) GTEST_SKIP() << "../shared/cases is missing";
  EXPECT_EQ(read(sharedCase("m02_code.log")).counts.beams_no_return, 3U * 181);
  const Result hall = read(sharedCase("c02_hall8183.log.gz"));
  EXPECT_EQ(hall.counts.no_return_from_m, 8.183);
  EXPECT_EQ(hall.counts.beams_no_return, 117945U);
  const Result near = read(sharedCase("m26.log"));
  EXPECT_EQ(near.counts.beams_too_near, 3U);
  EXPECT_TRUE(near.warns("3 beams are nearer"));
}

TEST_F(NoReturn, TheRealLogs) {
  struct Case {
    const char* file;
    double from_m;
    std::size_t beams;
  };
  for (const Case& c :
       {Case{"infinite-corridor/infinite-corridor-corrected.log.gz", 51.05, 4653},
        Case{"large-loops/acapulco-corrected.log.gz", 50, 13213},
        Case{"large-loops/aces-corrected.log.gz", 50, 620},
        Case{"mit-csail/mit-csail.clf.gz", 0, 0}, Case{"intel/intel-raw910.clf.gz", 0, 0},
        Case{"intel/mrpt-intel.rawlog", 0, 0}}) {
    if (realLog(c.file).empty()) GTEST_SKIP() << c.file << " is missing (set ARIADNE_DATASETS)";
    const Result r = read(realLog(c.file));
    EXPECT_NEAR(r.counts.no_return_from_m, c.from_m, 1e-9) << c.file;
    EXPECT_EQ(r.counts.beams_over_reach, c.beams) << c.file;
  }
}

TEST_F(NoReturn, MrptsSampleHasNoneBelowItsMaximum) {
  if (!std::filesystem::exists(kMrptSample)) GTEST_SKIP() << "package mrpt-common is missing";
  EXPECT_EQ(read(kMrptSample).counts.beams_over_reach, 0U);
}
