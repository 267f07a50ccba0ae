#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/slam/mapper.h"
#include "drive.h"
#include "few.h"

using namespace ariadne;
using slam::Mapper;
using test::few;
using test::worstError;

// Measured over seeds 1 to 10: worst 0.045 m to 0.061 m (odometry alone 0.75 m to 1.1 m).
TEST(Mapper, HoldsTheOvalWhereOdometryDoesNot) {
  const auto drive = test::ovalDrive(200);
  Mapper mapper(few(), 1);
  geometry::Trajectory odometry;
  for (const auto& step : drive.steps) {
    mapper.process(step);
    odometry.push_back({step.time_s, step.odom_from_robot});
  }
  ASSERT_EQ(mapper.path().size(), drive.steps.size());
  EXPECT_LT(worstError(mapper.path(), drive.truth), 0.1);
  EXPECT_GT(worstError(odometry, drive.truth), 0.5);
}

// MRPT's resampling draws from a generator that no caller hands over: it must be the thread's own.
TEST(Mapper, MappersInOtherThreadsChangeNothing) {
  const auto drive = test::ovalDrive(60);
  const auto mapped = [&](std::uint64_t seed) {
    SlamParams params = few(4);
    params.filter.seed = seed;
    params.filter.beta = 1;  // resamples at every update
    params.filter.resampling = filter::Resampling::multinomial;
    Mapper mapper(params, 1);
    for (const auto& step : drive.steps) mapper.process(step);
    return mapper.path();
  };
  const std::vector<geometry::Trajectory> alone = {mapped(1), mapped(2)};
  std::vector<geometry::Trajectory> together(2);
  std::thread beside([&] { together[1] = mapped(2); });
  together[0] = mapped(1);
  beside.join();
  for (std::size_t m = 0; m < 2; ++m)
    for (std::size_t i = 0; i < alone[m].size(); ++i)
      ASSERT_EQ(alone[m][i].pose, together[m][i].pose) << "mapper " << m << ", step " << i;
}

TEST(Mapper, SameSeedSameBitsOnAnyNumberOfThreads) {
  const auto drive = test::ovalDrive(80);
  std::vector<std::unique_ptr<Mapper>> mappers;
  for (int threads : {1, 2, 8}) {
    mappers.push_back(std::make_unique<Mapper>(few(), threads));
    for (const auto& step : drive.steps) mappers.back()->process(step);
  }
  const auto path = mappers[0]->path();
  const auto map = mappers[0]->map();
  for (std::size_t m = 1; m < mappers.size(); ++m) {
    const auto other = mappers[m]->path();
    for (std::size_t i = 0; i < path.size(); ++i) {
      EXPECT_EQ(path[i].pose.x, other[i].pose.x);
      EXPECT_EQ(path[i].pose.phi, other[i].pose.phi);
    }
    EXPECT_EQ(map.getRawMap(), mappers[m]->map().getRawMap());
  }
}

TEST(Mapper, AnotherSeedIsAnotherRun) {
  const auto drive = test::ovalDrive(40);
  auto params = few();
  Mapper one(params, 1);
  params.filter.seed = 2;
  Mapper two(params, 1);
  for (const auto& step : drive.steps) {
    one.process(step);
    two.process(step);
  }
  EXPECT_NE(one.path().back().pose.x, two.path().back().pose.x);
}

TEST(Mapper, UpdatesOnlyWhenTheRobotHasMoved) {
  const auto drive = test::ovalDrive(1);
  Mapper mapper(few(), 1);
  auto step = drive.steps[0];
  EXPECT_TRUE(mapper.process(step));
  step.odom_from_robot.x += 0.29;
  EXPECT_FALSE(mapper.process(step));
  step.odom_from_robot.x += 0.02;
  EXPECT_TRUE(mapper.process(step));
  step.odom_from_robot.phi += mrpt::DEG2RAD(16.0);
  EXPECT_TRUE(mapper.process(step));
  step.scan = nullptr;
  step.odom_from_robot.x += 5;
  EXPECT_FALSE(mapper.process(step));  // odometry alone only lengthens the path
  EXPECT_EQ(mapper.updates(), 3U);
  EXPECT_EQ(mapper.path().size(), 5U);
}

TEST(Mapper, ReportsWhatItDid) {
  const auto drive = test::ovalDrive(60);
  Mapper mapper(few(), 1);
  std::size_t updates = 0;
  for (const auto& step : drive.steps) {
    const auto report = mapper.process(step);
    if (!report) continue;
    EXPECT_EQ(report->step, updates++);
    EXPECT_EQ(report->time_s, step.time_s);
    EXPECT_GE(report->neff, 1);
    EXPECT_LE(report->neff, 8 + 1e-9);
    EXPECT_EQ(report->resampled, report->neff < 4);
    EXPECT_LE(report->matches_accepted, 8U);
    EXPECT_EQ(report->particles, 8U);
  }
  EXPECT_EQ(mapper.updates(), updates);
  EXPECT_EQ(mapper.simpleMap().size(), updates);
}

TEST(Mapper, WithoutAScanThereIsNoMapButAPath) {
  Mapper mapper(few(), 1);
  mapper.process({1, {0, 0, 0}, nullptr});
  mapper.process({2, {1, 0, 0}, nullptr});
  EXPECT_EQ(mapper.updates(), 0U);
  ASSERT_EQ(mapper.path().size(), 2U);
  EXPECT_EQ(mapper.path()[1].pose.x, 1);
  EXPECT_EQ(mapper.simpleMap().size(), 0U);
  EXPECT_EQ(mapper.map().getSizeX(), 1U);
}

TEST(Mapper, BlindScansAreNoUpdates) {
  auto drive = test::ovalDrive(30);
  for (auto& step : drive.steps)
    for (std::size_t i = 0; i < step.scan->getScanSize(); ++i)
      step.scan->setScanRangeValidity(i, false);
  Mapper mapper(few(), 2);
  for (const auto& step : drive.steps) mapper.process(step);
  EXPECT_EQ(mapper.updates(), 0U);
  EXPECT_EQ(mapper.path().back().pose.x, drive.steps.back().odom_from_robot.x);
}

TEST(Mapper, NamesAParameterOutOfBounds) {
  auto params = few();
  params.filter.beta = 2;
  try {
    Mapper mapper(params, 1);
    FAIL();
  } catch (const core::UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("[filter] beta"), std::string::npos) << e.what();
  }
}

TEST(Mapper, GoesOnInAKnownMap) {
  const auto drive = test::ovalDrive(120);
  Mapper first(few(), 1);
  for (std::size_t i = 0; i < 100; ++i) first.process(drive.steps[i]);
  Mapper second(few(), 1, first.simpleMap(), first.path().back().pose);
  for (std::size_t i = 99; i < 120; ++i) second.process(drive.steps[i]);
  EXPECT_EQ(second.simpleMap().size(), first.updates() + second.updates());
  const auto moved = geometry::relativePose(drive.truth[0], drive.truth[119]);
  const auto pose = geometry::relativePose(first.path()[0].pose, second.path().back().pose);
  EXPECT_LT(std::hypot(pose.x - moved.x, pose.y - moved.y), 0.1);
}
