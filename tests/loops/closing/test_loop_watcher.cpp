#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/loops/closing/loop_watcher.h"
#include "corridors.h"

using namespace ariadne;
using loops::LoopState;
using loops::LoopWatcher;

namespace {

constexpr double kRing_m = 14;

/// A ring with a corridor that leads away from (0, 0); the graph grows as the robot goes.
struct Ride {
  explicit Ride(loops::ClosingParams p = {}) : params(p), map(test::ringMap(kRing_m)), watcher(p) {
    test::drawRoom(map, -30, -1, 0, 1);
  }
  void along(const std::vector<mrpt::math::TPoint2D>& path) {
    for (const auto& p : path) to(p);
  }
  void to(const mrpt::math::TPoint2D& p) {
    if (!graph.visits().empty()) {
      const auto& last = graph.visits().back().position;
      travelled += std::hypot(p.x - last.x, p.y - last.y);
    }
    graph.extend(p, map, params.places);
    const auto events = watcher.observe({graph, map, {travelled, neff, 30, false, 0.1}});
    if (events.detected) log += "detected " + std::to_string(*events.detected) + "; ";
    if (events.entered) {
      log += "entered " + std::to_string(*events.entered) + "; ";
      const auto te = watcher.closings()[*events.entered].opportunity.te;
      graph.close(graph.visits()[te].place);
    }
    for (const auto name : events.given_up) log += "given up " + std::to_string(name) + "; ";
    if (events.ended) log += "ended " + std::to_string(*events.ended) + "; ";
  }
  void leave(double metres) {
    for (double x = 0.4; x < metres; x += 0.4) to({-x, 0});
  }
  loops::ClosingParams params;
  grid::OccupancyGrid map;
  loops::PlaceGraph graph;
  LoopWatcher watcher;
  double travelled = 0;
  double neff = 30;
  std::string log;
};

}  // namespace

TEST(LoopWatcher, OneLoopIsOneClosingHoweverManyLaps) {
  Ride ride;
  ride.along(test::ringPath(kRing_m, 4 * kRing_m - 8));
  EXPECT_EQ(ride.log, "detected 0; ");
  EXPECT_EQ(ride.watcher.state(), LoopState::approaching);
  Ride laps;
  laps.along(test::ringPath(kRing_m, 5 * 4 * kRing_m));
  EXPECT_EQ(laps.log, "detected 0; entered 0; ");
  EXPECT_EQ(laps.watcher.state(), LoopState::closing);
  laps.leave(12);
  EXPECT_EQ(laps.log, "detected 0; entered 0; ended 0; ");
  EXPECT_EQ(laps.watcher.state(), LoopState::exploring);
  const auto& c = laps.watcher.closings().at(0);
  EXPECT_EQ(c.end_reason, "the robot left what it knew");
  EXPECT_NEAR(c.course.loop_length_m, 4 * kRing_m - 10, 2.5);
  ASSERT_TRUE(c.neff_rule_m);
  EXPECT_NEAR(*c.neff_rule_m, laps.params.neff_window_m, 0.5) << "Neff was constant throughout";
}

TEST(LoopWatcher, GivesUpAnEntryThatTheRobotDoesNotComeTo) {
  loops::ClosingParams params;
  params.approach_limit_m = 12;
  Ride ride(params);
  ride.along(test::ringPath(kRing_m, 4 * kRing_m - 8));
  for (int i = 0; i < 50; ++i) ride.to({0, 8 + 0.4 * (i % 2)});  // to and fro
  EXPECT_NE(ride.log.find("given up 0"), std::string::npos) << ride.log;
  EXPECT_EQ(ride.watcher.closings()[0].end_reason, "the robot did not come to the entry");
}

TEST(LoopWatcher, TheSameLoopIsNotFoundAgainAfterAClosing) {
  Ride ride;
  ride.along(test::ringPath(kRing_m, 4 * kRing_m + 2));
  ride.leave(12);
  for (double x = 12; x > 0; x -= 0.4) ride.to({-x, 0});
  ride.along(test::ringPath(kRing_m, 2 * 4 * kRing_m));
  EXPECT_EQ(ride.log, "detected 0; entered 0; ended 0; ");
}

TEST(LoopWatcher, ThePapersRuleEndsAClosing) {
  loops::ClosingParams params;
  params.stop = loops::Stop::neff;
  Ride ride(params);
  ride.along(test::ringPath(kRing_m, 4 * kRing_m + 9));
  EXPECT_EQ(ride.log, "detected 0; entered 0; ");
  ride.along(test::ringPath(kRing_m, 20));
  EXPECT_EQ(ride.log, "detected 0; entered 0; ended 0; ");
  EXPECT_EQ(ride.watcher.closings()[0].end_reason, "Neff constant");
}

TEST(LoopWatcher, NeverEnds) {
  loops::ClosingParams params;
  params.stop = loops::Stop::never;
  Ride ride(params);
  ride.along(test::ringPath(kRing_m, 4 * kRing_m + 9));
  ride.leave(25);
  EXPECT_EQ(ride.log, "detected 0; entered 0; ");
  EXPECT_FALSE(ride.watcher.closings()[0].ended);
}

TEST(LoopWatcher, RefusesC1NotLessThanC2) {
  loops::ClosingParams params;
  params.opportunity.c1_m = 30;
  EXPECT_THROW(LoopWatcher{params}, core::UsageError);
}
