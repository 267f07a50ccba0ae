#include <fstream>

#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "ariadne/core/error.h"
#include "ariadne/experiment/drives.h"

using namespace ariadne;
using experiment::Drives;
using experiment::LoopConfig;

namespace {

const std::string kData = test::shippedDatasets().string();

LoopConfig logConfig() {
  LoopConfig config;
  config.files.log = kData + "/drives/small.rawlog";
  config.log_noise.motion = {0.05, 0.005, 0.02, 0.005};
  return config;
}

double lengthOf(const sim::SimulatedDrive& d) {
  double length = 0;
  for (std::size_t i = 1; i < d.steps.size(); ++i)
    length += std::hypot(d.steps[i].odom_from_robot.x - d.steps[i - 1].odom_from_robot.x,
                         d.steps[i].odom_from_robot.y - d.steps[i - 1].odom_from_robot.y);
  return length;
}

}  // namespace

TEST(Drives, ALogsPosesAreTheTruthAndEachSeedHasItsNoise) {
  const Drives drives(logConfig(), {});
  EXPECT_EQ(drives.name(), "small");
  const auto one = drives.observe(1);
  const auto again = drives.observe(1);
  const auto two = drives.observe(2);
  LoopConfig clean = logConfig();
  clean.log_noise.motion = {0, 0, 0, 0};
  const auto none = Drives(clean, {}).observe(1);
  ASSERT_EQ(one.steps.size(), one.truth.size());
  ASSERT_GT(one.steps.size(), 100U);
  const auto& last = one.steps.back().odom_from_robot;
  EXPECT_EQ(last.x, again.steps.back().odom_from_robot.x);
  EXPECT_NE(last.x, two.steps.back().odom_from_robot.x);
  EXPECT_NEAR(none.steps.back().odom_from_robot.x, one.truth.back().pose.x, 1e-9);
  EXPECT_NE(last.x, one.truth.back().pose.x);
  EXPECT_NEAR(lengthOf(one), lengthOf(none), 0.1 * lengthOf(none)) << "noise, not another drive";
}

TEST(Drives, StampsMayBeMade) {
  LoopConfig config = logConfig();
  config.log_noise.restamp_s = 0.5;
  const auto seen = Drives(config, {}).observe(1);
  EXPECT_EQ(seen.steps[3].time_s, 1.5);
  EXPECT_EQ(seen.truth[3].time_s, 1.5);
}

TEST(Drives, TakesEitherWorldAndPathOrLog) {
  LoopConfig config = logConfig();
  EXPECT_THROW(Drives(config, 3), core::UsageError) << "a log has no laps";
  config.files.world = kData + "/worlds/small.world";
  EXPECT_THROW(Drives(config, {}), core::UsageError);
  config.files.log = "";
  EXPECT_THROW(Drives(config, {}), core::UsageError) << "a world without a path";
  config.files.path = kData + "/drives/small.path";
  EXPECT_EQ(Drives(config, 2).laps(), 2);
  EXPECT_EQ(Drives(config, 2).name(), "small");
  config.files = {"", "", kData + "/none.log"};
  EXPECT_THROW(Drives(config, {}), core::Error);
}
