// Following routes, looking out, and the way through a loop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ariadne/explore/guard.h"
#include "ariadne/explore/loop_route.h"
#include "ariadne/explore/route_follower.h"
#include "ariadne/explore/strategy.h"
#include "ariadne/geometry/pose.h"

using namespace ariadne;
using explore::ExploreParams;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

namespace {

explore::Route corner() {
  explore::Route route;
  for (int i = 0; i <= 40; ++i) route.emplace_back(0.1 * i, 0);
  for (int i = 1; i <= 30; ++i) route.emplace_back(4, 0.1 * i);
  return route;
}

/// A straight line of updates, 0.5 m apart.
filter::AncestorPtr line(std::size_t updates) {
  filter::AncestorPtr leaf;
  for (std::size_t k = 0; k < updates; ++k)
    leaf = std::make_shared<filter::Ancestor>(leaf, k, TPose2D(0.5 * static_cast<double>(k), 0, 0),
                                              0.0);
  return leaf;
}

mrpt::obs::CObservation2DRangeScan scanWith(std::size_t beam, float range) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(M_PI);
  scan.maxRange = 10;
  scan.resizeScan(181);
  for (std::size_t i = 0; i < 181; ++i) {
    scan.setScanRange(i, 10);
    scan.setScanRangeValidity(i, false);
  }
  scan.setScanRange(beam, range);
  scan.setScanRangeValidity(beam, true);
  return scan;
}

}  // namespace

TEST(RouteFollower, StaysOnTheRouteAndStopsAtItsEnd) {
  const ExploreParams params;
  explore::RouteFollower follower(params);
  follower.take(corner());
  TPose2D robot(0, 0, M_PI);  // looks the other way
  double worst = 0;
  int steps = 0;
  for (; !follower.arrived(robot) && steps < 300; ++steps) {
    const auto c = follower.command(robot, {});
    EXPECT_LE(c.forward_m_s, params.speed_m_s);
    EXPECT_LE(std::abs(c.turn_rad_s), params.turn_deg_s * M_PI / 180 + 1e-9);
    robot = geometry::compose(robot, {c.forward_m_s * 0.2, 0, c.turn_rad_s * 0.2});
    double off = 1e9;
    for (const TPoint2D& p : follower.route())
      off = std::min(off, std::hypot(p.x - robot.x, p.y - robot.y));
    worst = std::max(worst, off);
  }
  EXPECT_TRUE(follower.arrived(robot));
  EXPECT_LT(steps, 150) << "30 s for 7 m";
  EXPECT_LT(worst, 0.3) << "a corner is cut by less than the lookahead";
  EXPECT_EQ(follower.command(robot, {}).forward_m_s, 0);
}

// Through a door of 0.8 m, along its wall and then in. Measured: 0.27 m off its frame; 0.18 m,
// which is a touch, where the laser is not heeded.
TEST(RouteFollower, DoesNotCutTheFrameOfADoor) {
  const ExploreParams params;
  explore::RouteFollower follower(params);
  explore::Route route;
  for (int k = 0; k <= 20; ++k) route.push_back({0.1 * k, 0});
  for (int k = 1; k <= 15; ++k) route.push_back({2, 0.1 * k});
  follower.take(route);
  std::vector<TPoint2D> frame;  // of a door between x = 1.72 and 2.52, its wall at y = 0.28
  for (int k = 0; k <= 30; ++k) {
    frame.push_back({1.72 - 0.05 * k, 0.28});
    frame.push_back({2.52 + 0.05 * k, 0.28});
  }
  TPose2D robot(0, 0, 0);
  double nearest = 1e9;
  for (int step = 0; !follower.arrived(robot) && step < 300; ++step) {
    std::vector<TPoint2D> hits;
    for (const TPoint2D& p : frame) {
      const TPose2D at = geometry::relativePose(robot, {p.x, p.y, 0});
      if (at.x > 0) hits.push_back({at.x, at.y});
      nearest = std::min(nearest, std::hypot(at.x, at.y));
    }
    const auto c = follower.command(robot, hits);
    robot = geometry::compose(robot, {c.forward_m_s * 0.2, 0, c.turn_rad_s * 0.2});
  }
  EXPECT_TRUE(follower.arrived(robot));
  EXPECT_GT(nearest, params.robot_radius_m + 0.02);
}

TEST(RouteFollower, WithoutARouteItStands) {
  explore::RouteFollower follower{ExploreParams{}};
  EXPECT_TRUE(follower.arrived({1, 2, 3}));
  EXPECT_EQ(follower.command({1, 2, 3}, {}).turn_rad_s, 0);
}

TEST(RouteFollower, FacesAPoint) {
  explore::RouteFollower follower{ExploreParams{}};
  TPose2D robot(1, 1, 0);
  for (int i = 0; i < 100; ++i) robot.phi += follower.face(robot, {1, 5}).turn_rad_s * 0.2;
  EXPECT_NEAR(robot.phi, M_PI / 2, 0.2);
}

TEST(Guard, HitsAreWhereBeamsEnd) {
  const auto ahead = explore::hitsOf(scanWith(90, 1.5F), 2);
  ASSERT_EQ(ahead.size(), 1U);
  EXPECT_NEAR(ahead[0].x, 1.5, 1e-6);
  EXPECT_NEAR(ahead[0].y, 0, 1e-6);
  const auto right = explore::hitsOf(scanWith(0, 1.5F), 2);
  EXPECT_NEAR(right.at(0).y, -1.5, 1e-6);
  EXPECT_TRUE(explore::hitsOf(scanWith(90, 3), 2).empty()) << "farther than asked for";
}

TEST(Guard, OnlyWhatStandsInTheDiscsWayBlocks) {
  const ExploreParams params;  // radius 0.2
  EXPECT_TRUE(explore::blocked({{0.3, 0}}, 0.15, params));
  EXPECT_FALSE(explore::blocked({{0.5, 0}}, 0.15, params));
  EXPECT_FALSE(explore::blocked({{0.3, 0.3}}, 0.15, params)) << "beside its way";
  EXPECT_FALSE(explore::blocked({{-0.3, 0}}, 0.15, params)) << "behind it";
  EXPECT_FALSE(explore::blocked({}, 0.15, params));
}

TEST(LoopRoute, LeadsAlongThePathInTheOrderOfTimeAndRoundAgain) {
  const auto leaf = line(61);
  explore::LoopRoute route(10, 50);
  TPose2D robot(5, 0, 0);  // at update 10
  double before = 5;
  for (int i = 0; i < 15 && route.laps() < 0.9; ++i) {
    const TPoint2D next = route.next(leaf, robot);
    EXPECT_GE(next.x, before);
    EXPECT_LE(next.x - robot.x, 4.6) << "a few metres ahead";
    before = next.x;
    robot.x = next.x;
  }
  EXPECT_GE(route.laps(), 0.9);
  for (int i = 0; i < 5 && route.laps() < 1; ++i) robot.x = route.next(leaf, robot).x;
  EXPECT_GE(route.laps(), 1);
  EXPECT_LT(route.next(leaf, {5, 0, 0}).x, 10) << "from te again";
}

TEST(LoopRoute, ABlockedPartIsSkipped) {
  const auto leaf = line(61);
  explore::LoopRoute route(10, 50);
  const TPoint2D first = route.next(leaf, {5, 0, 0});
  route.skip();
  EXPECT_GT(route.next(leaf, {5, 0, 0}).x, first.x);
}

TEST(Strategy, SetsTheRuleAndTheRecovery) {
  using explore::Strategy;
  const auto with = [](Strategy s) {
    slam::SlamParams p;
    explore::applyStrategy(s, p);
    return std::pair(p.loop_closing.stop, p.recovery.enabled);
  };
  EXPECT_EQ(with(Strategy::frontier), std::pair(loops::Stop::leaving, false));
  EXPECT_EQ(with(Strategy::active_uncertainty), std::pair(loops::Stop::uncertainty, false));
  EXPECT_EQ(with(Strategy::active_neff), std::pair(loops::Stop::neff, false));
  EXPECT_EQ(with(Strategy::active_neff_recovery), std::pair(loops::Stop::neff, true));
  EXPECT_FALSE(explore::isActive(Strategy::frontier));
}
