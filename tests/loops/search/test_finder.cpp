#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/geometry/pose.h"
#include "ariadne/loops/search/finder.h"
#include "corridor.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

// Of half a metre that scans were matched on.
const Eigen::Matrix3d kMotion = Eigen::Vector3d(4.5e-4, 1.1e-4, 1.4e-5).asDiagonal();

struct Walk {
  std::vector<TPose2D> truth;
  loops::Finder::Scans scans;
};

/// Once round the corridor and 15 m on, a scan each 0.5 m.
Walk walkIn(const test::CorridorWorld& world) {
  Walk w;
  w.truth = test::corridorDrive(0.5);
  for (std::size_t k = 0; k < 30; ++k) w.truth.push_back(w.truth[k]);
  core::RandomStream rng(3, 0, 0, core::Purpose::test);
  for (const auto& pose : w.truth)
    w.scans.push_back(mrpt::obs::CObservation2DRangeScan::Create(world.scan(pose, rng)));
  return w;
}

/// Its doors stand unevenly.
const Walk& walk() {
  static const Walk made = walkIn(test::CorridorWorld(2));
  return made;
}

/// The walk as a filter has it whose heading drifts by `turn_deg_per_m`; looks after each update.
/// @return the first closure and the update at which it was found
std::pair<std::optional<loops::Closure>, std::size_t> firstClosure(double turn_deg_per_m,
                                                                   const Walk& way = walk()) {
  loops::Finder finder({}, {}, {});
  loops::Finder::Scans scans;
  filter::AncestorPtr leaf;
  TPose2D pose = way.truth[0];
  for (std::size_t k = 0; k < way.truth.size(); ++k) {
    if (k > 0) {
      TPose2D step = geometry::relativePose(way.truth[k - 1], way.truth[k]);
      step.phi += turn_deg_per_m * M_PI / 180 * std::hypot(step.x, step.y);
      pose = geometry::compose(pose, step);
    }
    leaf = std::make_shared<filter::Ancestor>(leaf, k, pose, 0.0);
    scans.push_back(way.scans[k]);
    finder.add(grid::takeScan(scans.back(), {}, 180), kMotion);
    if (const auto found = finder.look(leaf, scans)) return {found, k};
  }
  return {std::nullopt, 0};
}

}  // namespace

TEST(Finder, FindsTheClosureFromMetresAway) {
  const double drift_deg_per_m = 0.08;
  const auto [found, update] = firstClosure(drift_deg_per_m);
  ASSERT_TRUE(found);
  const auto truth = geometry::relativePose(walk().truth[found->anchor], walk().truth[update]);
  EXPECT_LT(std::hypot(found->anchor_from_robot.x - truth.x, found->anchor_from_robot.y - truth.y),
            0.2);
  EXPECT_NEAR(found->anchor_from_robot.phi, truth.phi, 0.05);
  // It was metres away.
  EXPECT_GT(std::hypot(found->correction.x, found->correction.y), 1);
}

TEST(Finder, FindsNothingWhereThePathIsClosedAlready) { EXPECT_FALSE(firstClosure(0).first); }

// Doors every 5 m look alike: until a corner is seen there is more than one place, and none is
// taken.
TEST(Finder, TakesNoneOfTwoPlacesThatLookAlike) {
  const auto [found, update] = firstClosure(0.08, walkIn(test::CorridorWorld()));
  if (!found) return;
  const auto truth = geometry::relativePose(walk().truth[found->anchor], walk().truth[update]);
  EXPECT_LT(std::hypot(found->anchor_from_robot.x - truth.x, found->anchor_from_robot.y - truth.y),
            0.3);
}

TEST(Finder, FindsNothingBeforeTheLoopCloses) {
  loops::Finder finder({}, {}, {});
  loops::Finder::Scans scans;
  filter::AncestorPtr leaf;
  for (std::size_t k = 0; k < 150; ++k) {  // 75 of 100 m
    leaf = std::make_shared<filter::Ancestor>(leaf, k, walk().truth[k], 0.0);
    scans.push_back(walk().scans[k]);
    finder.add(grid::takeScan(scans.back(), {}, 180), kMotion);
    EXPECT_FALSE(finder.look(leaf, scans)) << k;
  }
}
