// Logs whose clock or readings do not make sense: what a run makes of them, and what it says.
#include <algorithm>

#include "slam_sense.h"

using namespace ariadne;

TEST_F(SlamSense, AClockThatIsSetBackChangesNoPose) {
  room_log::Options set_back;
  set_back.stamp = [](int i) { return i < 3 ? 9e8 + 0.2 * i : 1000 + 0.2 * i; };
  const std::string odd = put("odd.log", room_log::text(40, set_back));
  ASSERT_EQ(map("plain"), 0) << err;
  log = odd;
  ASSERT_EQ(map("odd"), 0) << err;
  EXPECT_EQ(countOf(err, "the clock was set back"), 1U) << err;
  const auto told = summary("odd");
  EXPECT_EQ(told["dataset"]["scans"], 40);
  EXPECT_NEAR(told["dataset"]["duration_s"].get<double>(), 7.6, 1e-6);
  auto plain = path("plain");
  auto other = path("odd");  // sorted by time: the first three are last
  ASSERT_EQ(other.size(), plain.size());
  std::rotate(other.begin(), other.end() - 3, other.end());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(other[i].pose, plain[i].pose) << i;
}

TEST_F(SlamSense, TruthIsFoundByTheLogsOwnStamps) {
  room_log::Options set_back;
  set_back.stamp = [](int i) { return i < 10 ? 9e8 + 0.2 * i : 1000 + 0.2 * i; };
  log = put("odd.log", room_log::text(40, set_back));
  ASSERT_EQ(map("first"), 0) << err;
  ASSERT_EQ(map("second", {"--truth", (folder / "first/trajectory.tum").string()}), 0) << err;
  EXPECT_LT(summary("second")["ate_rmse_m"].get<double>(), 1e-8);
}

TEST_F(SlamSense, StampsThatRunBackwardsAreAnError) {
  room_log::Options backwards;
  backwards.stamp = [](int i) { return 1000 - 0.2 * i; };
  log = put("back.log", room_log::text(40, backwards));
  EXPECT_EQ(map("back"), 1);
  EXPECT_NE(err.find("39 of 40 scans have stamps that neither"), std::string::npos) << err;
}

TEST_F(SlamSense, ACodeForNothingMapsAsNoReturnDoes) {
  room_log::Options reach;
  reach.reading = [](double r) { return r < 5 ? r : 81.91; };
  log = put("plain.log", room_log::text(60, reach));
  ASSERT_EQ(map("plain"), 0) << err;
  for (const double code : {8.183, 8.191, 9.99, 32.76, 50.0, 51.15}) {
    reach.reading = [=](double r) { return r < 5 ? r : code; };
    log = put("coded.log", room_log::text(60, reach));
    ASSERT_EQ(map("coded", {"--overwrite"}), 0) << err;
    EXPECT_EQ(countOf(err, "are taken for no return"), 1U) << code << err;
    EXPECT_EQ(io::readWhole(folder / "coded/map.pgm"), io::readWhole(folder / "plain/map.pgm"))
        << code;
  }
}

TEST_F(SlamSense, WhatIsTooNearIsNoWallAtTheRobot) {
  room_log::Options spoilt;
  spoilt.reading = [n = 0](double r) mutable { return ++n % 50 == 0 ? 0.0 : r; };
  log = put("zeros.log", room_log::text(40, spoilt));
  ASSERT_EQ(map("zeros"), 0) << err;
  spoilt.reading = [n = 0](double r) mutable { return ++n % 50 == 0 ? 0.006 : r; };
  log = put("near.log", room_log::text(40, spoilt));
  ASSERT_EQ(map("near"), 0) << err;
  EXPECT_EQ(countOf(err, "nearer than [dataset] min_range_m"), 1U) << err;
  EXPECT_EQ(io::readWhole(folder / "near/map.pgm"), io::readWhole(folder / "zeros/map.pgm"));
}

TEST_F(SlamSense, AClockwiseLaserMapsAsTheOtherDoes) {
  ASSERT_EQ(map("plain"), 0) << err;
  room_log::Options turned;
  turned.clockwise = true;
  log = put("turned.log", room_log::text(40, turned));
  ASSERT_EQ(map("turned"), 0) << err;
  EXPECT_EQ(err.find("warning"), err.npos) << err;
  EXPECT_LT(farthest(path("turned"), path("plain")), 0.02);  // angles of six digits
}
