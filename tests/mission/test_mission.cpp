#include <gtest/gtest.h>

#include <algorithm>

#include "../shipped_datasets.h"
#include "ariadne/explore/strategy.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/mission/mission.h"

using namespace ariadne;
using explore::DecisionKind;
using mission::Mission;
using mission::MissionParams;
using mission::MissionRecord;

namespace {

MissionParams gentle() {
  MissionParams p;
  p.slam.filter.particles = 10;
  p.slam.grid.resolution_m = 0.1;
  p.slam.grid.no_return_free_m = 10;
  p.slam.loop_closing.opportunity.c1_m = 10;
  p.slam.loop_closing.opportunity.c2_m = 20;
  p.sim.drive.max_range_m = 10;
  p.explore.max_time_s = 900;
  return p;
}

sim::World shipped(const char* name) {
  return sim::readWorld(test::shippedDatasets() / "worlds" / name);
}

std::size_t count(const Mission& m, DecisionKind kind) {
  const auto& all = m.explorer().decisions();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const auto& d) { return d.kind == kind; }));
}

/// Share of the world's free floor that the map has as free.
double covered(const Mission& m, const sim::World& world) {
  const mrpt::maps::COccupancyGridMap2D map = m.mapper().map();
  std::size_t floor = 0;
  std::size_t seen = 0;
  for (unsigned y = 0; y < world.map.getSizeY(); ++y)
    for (unsigned x = 0; x < world.map.getSizeX(); ++x) {
      if (world.map.getCell(static_cast<int>(x), static_cast<int>(y)) <= 0.6F) continue;
      ++floor;
      const mrpt::math::TPose2D at(world.map.idx2x(x), world.map.idx2y(y), 0);
      const auto in_map = geometry::relativePose(*world.start, at);
      seen += map.getPos(static_cast<float>(in_map.x), static_cast<float>(in_map.y)) > 0.6F;
    }
  return static_cast<double>(seen) / static_cast<double>(floor);
}

/// Explores a drawn world to its end, which must come before the limits.
struct Explored {
  Explored(const char* text, const MissionParams& params)
      : world(sim::parseWorld(text, "drawn.world")),
        mission(world, *world.start, params, 1),
        record(mission.run()) {}
  const std::vector<explore::Candidate>& left() const {
    return mission.explorer().decisions().back().frontiers;
  }
  sim::World world;
  Mission mission;
  MissionRecord record;
};

}  // namespace

TEST(Mission, ExploresAWorldAndClosesItsLoops) {
  const sim::World world = shipped("small.world");
  Mission m(world, *world.start, gentle(), 1);
  const MissionRecord record = m.run();
  EXPECT_EQ(record.end_reason.rfind("explored", 0), 0U) << record.end_reason;
  EXPECT_TRUE(record.collisions.empty());
  // Cells cut by walls and corners that no beam enters are missing. That the map is right is not
  // looked at here: ten particles may err.
  EXPECT_GT(covered(m, world), 0.9);
  EXPECT_GE(count(m, DecisionKind::approach), 1U);
  EXPECT_GE(count(m, DecisionKind::follow), 1U);
  for (const auto& d : m.explorer().decisions()) {
    if (d.kind != DecisionKind::approach) continue;
    ASSERT_TRUE(d.loop);
    EXPECT_LT(d.loop->dist_m, 10) << "c1";
    EXPECT_GT(d.loop->dist_g, 20) << "c2";
  }
  std::size_t recovered = 0;
  for (const auto& c : m.mapper().closings()) recovered += c.recovery.has_value();
  EXPECT_GE(recovered, 1U);
  EXPECT_LT(m.explorer().slowestDecision_s(), 0.05);
}

TEST(Mission, TheFrontierStrategyDrivesNoLoopOnPurpose) {
  const sim::World world = shipped("small.world");
  MissionParams params = gentle();
  params.explore.strategy = explore::Strategy::frontier;
  Mission m(world, *world.start, params, 1);
  EXPECT_EQ(m.run().end_reason.rfind("explored", 0), 0U);
  EXPECT_EQ(count(m, DecisionKind::approach), 0U);
  for (const auto& c : m.mapper().closings()) EXPECT_FALSE(c.recovery);
}

TEST(Mission, SameBitsOnAnyNumberOfThreads) {
  const sim::World world = shipped("small.world");
  MissionParams params = gentle();
  params.explore.max_distance_m = 40;
  Mission one(world, *world.start, params, 1);
  Mission three(world, *world.start, params, 3);
  const MissionRecord a = one.run();
  const MissionRecord b = three.run();
  ASSERT_EQ(a.truth.size(), b.truth.size());
  for (std::size_t i = 0; i < a.truth.size(); ++i) EXPECT_EQ(a.truth[i].pose, b.truth[i].pose);
  EXPECT_EQ(one.explorer().decisions().size(), three.explorer().decisions().size());
  params.slam.filter.seed = 2;
  const MissionRecord c = Mission(world, *world.start, params, 1).run();
  EXPECT_NE(c.steps.back().odom_from_robot, a.steps.back().odom_from_robot);
}

TEST(Mission, ScansAreStampedWithTheirTimeToTheTick) {
  const sim::World world = shipped("small.world");
  MissionParams params = gentle();
  params.sim.drive.scan_rate_hz = 3;
  params.explore.max_distance_m = 20;
  const MissionRecord record = Mission(world, *world.start, params, 1).run();
  for (const auto& step : record.steps)
    EXPECT_EQ(mrpt::Clock::toDouble(step.scan->timestamp), step.time_s);
}

TEST(Mission, ItsStepsMapAgainToTheSameBits) {
  const sim::World world = shipped("small.world");
  MissionParams params = gentle();
  Mission m(world, *world.start, params, 1);
  const MissionRecord record = m.run();
  explore::applyStrategy(params.explore.strategy, params.slam);
  slam::Mapper again(params.slam, 2);
  for (const auto& step : record.steps) again.process(step);
  const auto path = m.mapper().path();
  const auto same = again.path();
  ASSERT_EQ(path.size(), same.size());
  for (std::size_t i = 0; i < path.size(); ++i) EXPECT_EQ(path[i].pose, same[i].pose);
}

TEST(Mission, AClosedRoomIsExploredByLookingAround) {
  const Explored e("room 0 0 4 5\nstart 2 2 0", gentle());
  EXPECT_EQ(e.record.end_reason.rfind("explored", 0), 0U) << e.record.end_reason;
  EXPECT_LT(e.record.distance_m, 8);
  EXPECT_TRUE(e.record.collisions.empty());
}

TEST(Mission, AStartBesideAWallCanBeLeft) {
  const Explored e("corridor 2  0 0  8 0\nroom 6 0 9 5\nstart 0 -0.75 180", gentle());
  EXPECT_EQ(e.record.end_reason.rfind("explored", 0), 0U) << e.record.end_reason;
  EXPECT_GT(e.record.distance_m, 2);
  EXPECT_TRUE(e.record.collisions.empty());
}

TEST(Mission, AHoleNarrowerThanTheRobotIsNotTried) {
  const Explored e("room 0 0 5 5\nroom 6 0 12 5\nroom 4.9 2.35 6.1 2.65\nstart 2 2 0", gentle());
  EXPECT_EQ(e.record.end_reason.rfind("explored", 0), 0U) << e.record.end_reason;
  EXPECT_TRUE(e.record.collisions.empty());
  for (const auto& t : e.record.truth) EXPECT_LT(t.pose.x, 5);
  const auto behind = std::count_if(e.left().begin(), e.left().end(),
                                    [](const auto& c) { return c.left == "no route leads there"; });
  EXPECT_GE(behind, 1) << "the other room, seen through the hole";
}

TEST(Mission, AnIslandIsGoneAround) {
  const Explored e("room 0 0 14 10\nwall 5 3 9 7\nstart 2 2 0", gentle());
  EXPECT_EQ(e.record.end_reason.rfind("explored", 0), 0U) << e.record.end_reason;
  EXPECT_TRUE(e.record.collisions.empty());
  EXPECT_GT(covered(e.mission, e.world), 0.9);
}

TEST(Mission, AnIslandBehindGlassIsLeftForAReason) {
  const Explored e(
      "room 0 0 14 10\nglass 4 2 10 2.1\nglass 4 8 10 8.1\nglass 4 2 4.1 8.1\n"
      "glass 10 2 10.1 8.1\nstart 2 1 0",
      gentle());
  EXPECT_EQ(e.record.end_reason.rfind("explored", 0), 0U) << e.record.end_reason;
  for (const auto& t : e.record.truth)
    EXPECT_FALSE(t.pose.x > 4.1 && t.pose.x < 10 && t.pose.y > 2.1 && t.pose.y < 8)
        << "never through glass";
  for (const auto& c : e.left()) EXPECT_FALSE(c.left.empty());
}

TEST(Mission, GlassIsTouchedHeldAndLeft) {
  const Explored e("corridor 2  0 0  12 0\nroom 10 -4 16 4\nglass 6 -1 6.1 1\nstart 1 0 0",
                   gentle());
  EXPECT_FALSE(e.record.end_reason.empty());
  EXPECT_NE(e.record.end_reason, "max_time_s is over");
  EXPECT_GE(e.record.collisions.size(), 1U);
  EXPECT_EQ(e.record.collisions.size() > 0, count(e.mission, DecisionKind::touched) > 0);
  for (const auto& t : e.record.truth) EXPECT_LE(t.pose.x, 6 - 0.2 + 1e-6) << "never through it";
}

TEST(Mission, AnEmptyFieldBeyondTheRangeEndsByItsLimits) {
  MissionParams params = gentle();
  params.sim.drive.max_range_m = 3;
  params.slam.grid.no_return_free_m = 0;
  const Explored unknown("room 0 0 60 60\nstart 30 30 0", params);
  EXPECT_FALSE(unknown.record.end_reason.empty());
  EXPECT_LT(unknown.record.distance_m, 1) << "nothing is known to be free";
  params.slam.grid.no_return_free_m = 3;
  params.explore.max_distance_m = 30;
  const Explored field("room 0 0 60 60\nstart 30 30 0", params);
  EXPECT_EQ(field.record.end_reason, "max_distance_m is driven");
}

TEST(Mission, AStartInRockIsAnError) {
  const sim::World world = shipped("small.world");
  EXPECT_THROW(Mission(world, {-50, -50, 0}, gentle(), 1).run(), core::Error);
}

TEST(Mission, AListenerStopsIt) {
  const sim::World world = shipped("small.world");
  Mission m(world, *world.start, gentle(), 1);
  const auto record = m.run([](const slam::StepReport& r, const auto&) { return r.step < 10; });
  EXPECT_EQ(record.end_reason, "stopped");
  EXPECT_EQ(record.reports.size(), 11U);
}
