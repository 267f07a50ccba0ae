#include <gtest/gtest.h>

#include "ariadne/checks/checks.h"

using namespace ariadne::checks;

namespace {

/// A drive of 100 m in 1000 scans that was mapped as it should be.
DriveFigures goodDrive() { return {1000, 0, 0, 100}; }
MapFigures goodMap() { return {300, 100, 9000, 8000}; }

std::string allWarnings(const std::vector<Check>& checks) {
  std::string all;
  for (const std::string& w : warningsOf(checks)) all += w + "\n";
  return all;
}

double valueOf(const std::vector<Check>& checks, const std::string& name) {
  for (const Check& c : checks)
    if (c.name == name) return c.value;
  ADD_FAILURE() << name;
  return -1;
}

}  // namespace

TEST(Checks, AGoodRunIsFine) {
  EXPECT_EQ(allWarnings(checkLog(goodDrive(), 3)), "");
  const auto checks = checkMap(goodDrive(), goodMap());
  EXPECT_EQ(allWarnings(checks), "");
  EXPECT_DOUBLE_EQ(valueOf(checks, "path_to_odometry"), 1);
  EXPECT_DOUBLE_EQ(valueOf(checks, "updates_per_scan"), 0.3);
  EXPECT_NEAR(valueOf(checks, "matches_accepted_share"), 8.0 / 9, 1e-12);
}

TEST(Checks, APathMuchShorterThanTheOdometry) {
  MapFigures map = goodMap();
  map.path_m = 4.8;
  const std::string told = allWarnings(checkMap(goodDrive(), map));
  EXPECT_NE(told.find("mapped path is 4.8 m long, the odometry's 100.0 m"), std::string::npos);
  EXPECT_NE(told.find("max_range_m"), std::string::npos);
}

TEST(Checks, APathMuchLongerThanTheOdometry) {
  MapFigures map = goodMap();
  map.path_m = 140;
  EXPECT_NE(allWarnings(checkMap(goodDrive(), map)).find("odometry misses motion"),
            std::string::npos);
  DriveFigures still = goodDrive();
  still.odometry_m = 0;
  map.path_m = 20;
  EXPECT_NE(allWarnings(checkMap(still, map)).find("odometry misses motion"), std::string::npos);
}

TEST(Checks, AShortWayTellsNothing) {
  DriveFigures drive = goodDrive();
  drive.odometry_m = 2;
  MapFigures map = goodMap();
  map.path_m = 1;
  EXPECT_EQ(allWarnings(checkMap(drive, map)), "");
}

TEST(Checks, OdometryThatStandsWhileTheScansChange) {
  DriveFigures drive = goodDrive();
  drive.odometry_m = 0;
  drive.standing_scans = 990;
  const auto checks = checkLog(drive, 0);
  EXPECT_NE(allWarnings(checks).find("odometry = scans"), std::string::npos);
  EXPECT_DOUBLE_EQ(valueOf(checks, "standing_scans_share"), 0.99);
  drive.standing_scans = 40;  // people
  EXPECT_EQ(allWarnings(checkLog(drive, 0)), "");
}

TEST(Checks, BlindScans) {
  DriveFigures drive = goodDrive();
  drive.blind_scans = 60;
  EXPECT_NE(allWarnings(checkLog(drive, 0)).find("in 60 of 1000 scans hardly a beam"),
            std::string::npos);
  drive.blind_scans = 40;
  EXPECT_EQ(allWarnings(checkLog(drive, 0)), "");
  EXPECT_EQ(allWarnings(checkLog({3, 3, 0, 0}, 0)), "");
}

TEST(Checks, MostScansSkipped) {
  EXPECT_NE(allWarnings(checkLog(goodDrive(), 300)).find("only 1000 of 1300 scans"),
            std::string::npos);
  EXPECT_EQ(allWarnings(checkLog(goodDrive(), 200)), "");
}

TEST(Checks, FewMatchesAccepted) {
  MapFigures map = goodMap();
  map.matches_accepted = 3000;
  EXPECT_NE(allWarnings(checkMap(goodDrive(), map)).find("only 33 %"), std::string::npos);
  map.matches_tried = map.matches_accepted = 0;  // another proposal
  EXPECT_EQ(allWarnings(checkMap(goodDrive(), map)), "");
}
