// A map's walls against the world's: what a person would call right gets a score near 1, and what
// is bent does not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/eval/alignment.h"
#include "ariadne/eval/loop_errors.h"
#include "ariadne/eval/map_score.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/mission/coverage.h"
#include "ariadne/sim/drive.h"
#include "ariadne/sim/walls.h"

using namespace ariadne;

namespace {

constexpr double kCell_m = 0.1;
constexpr double kTolerance_m = 0.25;

const char* kAmongThePillars =
    "goto 26 2\ngoto 26 26\ngoto 2 26\ngoto 2 6.5\ngoto 21.5 6.5\ngoto 21.5 21.5\ngoto 6.5 21.5\n"
    "goto 6.5 11.5\ngoto 16.5 11.5\ngoto 16.5 16.5\ngoto 2 16.5\ngoto 2 2\n";
const char* kRoundTheRing = "goto 20 0\ngoto 20 14\ngoto 0 14\ngoto 0 0\ngoto 8 0\n";

/// A hall of 28 x 28 m with 25 pillars.
sim::World hall() {
  std::string text = "room 0 0 28 28\nstart 2 2 0\n";
  for (int x = 4; x <= 24; x += 5)
    for (int y = 4; y <= 24; y += 5)
      text += fmt::format("wall {} {} {} {}\n", x - 0.3, y - 0.3, x + 0.3, y + 0.3);
  return sim::parseWorld(text, "hall.world");
}

/// A ring of corridors, 20 x 14 m.
sim::World ring() {
  return sim::parseWorld("corridor 2 0 0 20 0 20 14 0 14 0 0\nstart 0 0 0\n", "ring.world");
}

struct Driven {
  sim::World world;
  sim::DriveParams params;
  sim::SimulatedDrive seen;

  Driven(sim::World w, const std::string& path) : world(std::move(w)) {
    params.max_range_m = 10;
    params.scan_rate_hz = 2;
    seen = sim::observe(sim::driveThrough(world, sim::parsePath(path, "test.path", {}), params), {},
                        1);
  }

  /// Walls of the map that the scans make at these poses.
  std::vector<mrpt::math::TPoint2D> mapped(const geometry::Trajectory& path) const {
    return eval::wallsOf(mission::sighted(seen.steps, path, kCell_m));
  }
  eval::MapScore score(const geometry::Trajectory& path) const {
    const auto truth_from_map = eval::align(eval::associate(path, seen.truth, 0));
    return eval::mapScore(mapped(path), sim::wallsHit(world, seen.truth, params), truth_from_map,
                          kTolerance_m, world.map.getResolution());
  }
  /// The true path, bent by so much halfway, right at both ends.
  geometry::Trajectory bent(double by_m) const {
    geometry::Trajectory path = seen.truth;
    const double last = path.back().time_s;
    for (auto& p : path) {
      const double b = by_m * std::sin(M_PI * p.time_s / last);
      p.pose.x += b;
      p.pose.y += b;
    }
    return path;
  }
};

}  // namespace

TEST(MapAgainstWorld, AHallOfPillarsIsRightWithTheTruePoses) {
  const Driven drive(hall(), kAmongThePillars);
  const auto score = drive.score(drive.seen.truth);
  EXPECT_GT(score.precision, 0.99);
  // 3 % of the walls that were hit are not in the map (measured).
  EXPECT_GT(score.recall, 0.95);
}

// Measured: 0.80 and 0.58 in the hall; 0.90 and 0.72 in the ring, half of whose walls are moved
// along themselves. Bent by 0.1 m: 0.98 and 1.00.
TEST(MapAgainstWorld, ABentMapIsNotRight) {
  const Driven in_hall(hall(), kAmongThePillars);
  EXPECT_GT(in_hall.score(in_hall.bent(0.1)).f1, 0.95);
  EXPECT_LT(in_hall.score(in_hall.bent(0.5)).f1, 0.85);
  EXPECT_LT(in_hall.score(in_hall.bent(0.7)).f1, 0.65);
  const Driven in_ring(ring(), kRoundTheRing);
  EXPECT_GT(in_ring.score(in_ring.bent(0.1)).f1, 0.99);
  EXPECT_LT(in_ring.score(in_ring.bent(0.5)).f1, 0.93);
  EXPECT_LT(in_ring.score(in_ring.bent(0.7)).f1, 0.75);
}

// The true closures lie where both ends are right: they say nothing of what was bent in between.
TEST(MapAgainstWorld, ClosuresAloneCallABentMapCorrect) {
  const Driven drive(ring(), kRoundTheRing);
  const auto errors = eval::loopErrors(drive.bent(0.5), drive.seen.truth, 0);
  EXPECT_GT(errors.closures.size(), 5U);
  EXPECT_EQ(eval::verdictOf(errors), eval::Verdict::correct);
}
