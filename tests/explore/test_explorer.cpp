// The explorer step by step, on scans of a room.
#include <gtest/gtest.h>

#include <algorithm>

#include "../room.h"
#include "ariadne/explore/explorer.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

/// Walls and nothing else: all of it is seen from anywhere.
mrpt::maps::COccupancyGridMap2D bareRoom() {
  mrpt::maps::COccupancyGridMap2D world(-4, 4, -3, 3, 0.05F);
  world.fill(0.9F);
  for (unsigned y = 0; y < world.getSizeY(); ++y)
    for (unsigned x = 0; x < world.getSizeX(); ++x)
      if (std::min({x, y, world.getSizeX() - 1 - x, world.getSizeY() - 1 - y}) < 4)
        world.setCell(static_cast<int>(x), static_cast<int>(y), 0);
  return world;
}

/// A robot that is driven by the test; the explorer is asked what it would do.
struct Room {
  explicit Room(const explore::ExploreParams& params) : explorer(params) {}

  models::VelocityCommand at(double time_s, const TPose2D& pose, bool touched = false) {
    return look(time_s, pose, test::scanIn(world, pose, 0, 2 * M_PI), touched);
  }
  models::VelocityCommand look(double time_s, const TPose2D& pose,
                               const mrpt::obs::CObservation2DRangeScan::Ptr& scan,
                               bool touched = false) {
    mapper.process({time_s, pose, scan});
    return explorer.step(explore::beliefOf(mapper, time_s, *scan, touched));
  }
  /// Turned about once, and carried along a line while it does.
  double lookAround(const TPose2D& from, const TPose2D& to) {
    double time_s = 0;
    for (int i = 0; i <= 40; ++i, time_s += 0.2) {
      const double share = std::min(1.0, i / 36.0);
      at(time_s,
         {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), 2 * M_PI * i / 36});
    }
    return time_s;
  }
  std::size_t count(explore::DecisionKind kind) const {
    std::size_t n = 0;
    for (const auto& d : explorer.decisions()) n += d.kind == kind;
    return n;
  }

  static slam::SlamParams oneParticle() {
    slam::SlamParams params;
    params.filter.particles = 1;
    return params;
  }
  mrpt::maps::COccupancyGridMap2D world = bareRoom();
  slam::Mapper mapper{oneParticle(), 1};
  explore::Explorer explorer;
};

}  // namespace

TEST(Explorer, ItsTimeBeginsWithTheFirstScanAndNotIn1970) {
  explore::ExploreParams params;
  params.max_time_s = 60;
  Room room(params);
  constexpr double kUnix_s = 1.7e9;  // as a robot's driver gives it
  const auto doneAt = [&](double since_start_s) {
    room.at(kUnix_s + since_start_s, {});
    return room.explorer.done();
  };
  EXPECT_FALSE(doneAt(0)) << room.explorer.endReason();
  EXPECT_FALSE(doneAt(59));
  EXPECT_TRUE(doneAt(60));
  EXPECT_EQ(room.explorer.endReason(), "max_time_s is over");
}

TEST(Explorer, ABumpInTheMomentOfTheEndDoesNotGoOn) {
  explore::ExploreParams params;
  params.max_time_s = 60;
  Room room(params);
  room.at(0, {});
  EXPECT_EQ(room.at(60, {}, true).forward_m_s, 0);
  EXPECT_TRUE(room.explorer.done());
  EXPECT_EQ(room.explorer.decisions().size(), 1U);
  EXPECT_EQ(room.explorer.doing(), "done: max_time_s is over");
}

TEST(Explorer, AWayHomeThatIsGivenUpIsTheEnd) {
  explore::ExploreParams params;
  params.drive_home = true;
  params.giveup = 1;
  Room room(params);
  const TPose2D there(2.2, 0, 0);
  double time_s = room.lookAround({-1.5, 0, 0}, there);
  ASSERT_EQ(room.explorer.doing(), "driving home");
  const TPose2D here = room.mapper.pose();
  for (int i = 0; i < 40 && !room.explorer.done(); ++i, time_s += 0.2) {
    // Whichever way the robot looks, something that is not in the map stands before it.
    const TPose2D pose(there.x, there.y, there.phi + M_PI + 0.05 * (i % 2));
    auto scan = test::scanIn(room.world, pose, 0, 2 * M_PI);
    for (std::size_t b = 88; b <= 92; ++b) scan->setScanRange(b, 0.25F);
    room.look(time_s, pose, scan);
  }
  ASSERT_TRUE(room.explorer.done()) << room.explorer.doing() << " from " << here;
  EXPECT_EQ(room.explorer.endReason().rfind("explored; ", 0), 0U) << room.explorer.endReason();
  EXPECT_EQ(room.count(explore::DecisionKind::end), 1U);
}
