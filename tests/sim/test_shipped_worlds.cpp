// Every world and drive that is shipped can be driven, and is what its comments say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../shipped_datasets.h"
#include "ariadne/sim/drive.h"
#include "ariadne/sim/robot.h"

using namespace ariadne::sim;  // NOLINT: a test of this namespace
using ariadne::test::shippedDatasets;
namespace fs = std::filesystem;

namespace {

fs::path worldOf(const fs::path& drive) {
  std::string stem = drive.stem().string();
  if (const auto at = stem.find("_no_inner"); at != std::string::npos) stem.resize(at);
  return shippedDatasets() / "worlds" / (stem + ".world");
}

double lengthUntil(const TruthDrive& drive, double time_s) {
  double sum = 0;
  for (std::size_t i = 1; i < drive.poses.size() && drive.poses[i].time_s <= time_s; ++i)
    sum += (drive.poses[i].pose - drive.poses[i - 1].pose).norm();
  return sum;
}

}  // namespace

TEST(ShippedWorlds, AllDrivesArrive) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(shippedDatasets() / "drives")) {
    if (entry.path().extension() != ".path") continue;
    SCOPED_TRACE(entry.path().string());
    ++count;
    const World world = readWorld(worldOf(entry.path()));
    const TruthDrive drive = driveThrough(world, readPath(entry.path()), {});
    ASSERT_GE(drive.marks.size(), 2U);
    EXPECT_EQ(drive.marks.front().name, "A");
    EXPECT_EQ(drive.marks.back().name, "C");
    // The outer loop is closed at C: the robot is back where it started, within what counts as
    // reached and the way from scan to scan.
    const auto at = static_cast<std::size_t>(drive.marks.back().time_s * 5);
    EXPECT_LT((drive.poses.at(at).pose - *world.start).norm(), 0.45);
    EXPECT_GT(lengthUntil(drive, 1e9) - lengthUntil(drive, drive.marks.back().time_s), 10)
        << "known corridor after the closure";
  }
  EXPECT_EQ(count, 7);
}

TEST(ShippedWorlds, ARobotCanStandAtEveryStart) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(shippedDatasets() / "worlds")) {
    SCOPED_TRACE(entry.path().string());
    ++count;
    const World world = readWorld(entry.path());
    ASSERT_TRUE(world.start);
    EXPECT_NO_THROW(Robot(world, *world.start, {}));
  }
  EXPECT_EQ(count, 9);
}

TEST(ShippedWorlds, ALapOfTheInnerRingIsItsLength) {
  const World world = readWorld(shippedDatasets() / "worlds/nested.world");
  const fs::path path = shippedDatasets() / "drives/nested.path";
  const auto length = [&](int laps) {
    return lengthUntil(driveThrough(world, readPath(path, laps), {}), 1e9);
  };
  // 4 x 14 m; each of the four corners is cut by 0.3 m, and the way back to the line adds a little.
  EXPECT_NEAR(length(2) - length(1), 56, 1.2);
  EXPECT_NEAR(length(6) - length(1), 5 * (length(2) - length(1)), 0.1);
}
