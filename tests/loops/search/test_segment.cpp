#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/geometry/pose.h"
#include "ariadne/loops/search/segment.h"

using namespace ariadne;
using loops::Track;
using mrpt::math::TPose2D;

namespace {

/// Standard deviations per root metre.
struct Drift {
  double along = 0.03;
  double across = 0.015;
  double turn_deg = 0.3;
};

Track drifting(Track track, const Drift& d) {
  const double turn = d.turn_deg * M_PI / 180;
  const Eigen::Vector3d per_m(d.along * d.along, d.across * d.across, turn * turn);
  track.motion_covariance.assign(1, Eigen::Matrix3d::Zero());
  for (std::size_t k = 1; k < track.poses.size(); ++k)
    track.motion_covariance.push_back(
        ((track.travelled_m[k] - track.travelled_m[k - 1]) * per_m).asDiagonal());
  return track;
}

/// A path of `n` steps of `step_m` that turns a little.
Track curve(std::size_t n, double step_m, double turn, const TPose2D& start = {0, 0, 0}) {
  Track track;
  TPose2D pose = start;
  for (std::size_t k = 0; k <= n; ++k) {
    track.poses.push_back(pose);
    track.travelled_m.push_back(step_m * static_cast<double>(k));
    track.motions.emplace_back(step_m, 0, turn);
    pose = geometry::compose(pose, {step_m, 0, turn});
  }
  return drifting(track, {});
}

loops::Tie tie(std::size_t first, std::size_t second, const TPose2D& relative, double sigma_m) {
  const double i = 1 / (sigma_m * sigma_m);
  return {first, second, relative, Eigen::Vector3d(i, i, 4 * i).asDiagonal(), false};
}

double off(const TPose2D& a, const TPose2D& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

TEST(Segment, WithoutAClosureTheWayStaysAsItIs) {
  const Track track = curve(100, 0.3, 0.02);
  const auto mean = loops::drawSegment(track, 10, {}, nullptr);
  ASSERT_EQ(mean.poses.size(), 90u);
  for (std::size_t k = 0; k < 90; ++k) EXPECT_LT(off(mean.poses[k], track.poses[11 + k]), 1e-9);
  EXPECT_NEAR(mean.cost, 0, 1e-12);
}

TEST(Segment, StepsThatCannotBeWrongAreNotMoved) {
  const Track track = drifting(curve(60, 0.5, 0.1), {0, 0, 0});
  const auto relative = geometry::relativePose(track.poses[0], track.poses[60]);
  const auto mean = loops::drawSegment(
      track, 0, {tie(0, 60, geometry::compose(relative, {1, 0, 0}), 0.05)}, nullptr);
  // 1 mm a metre is left to them so that the chain is never singular; the closure asks for 1 m.
  EXPECT_LT(off(mean.poses.back(), track.poses[60]), 0.05);
  EXPECT_GT(mean.cost, 50);
}

TEST(Segment, EndsWhereTheClosureSaysAndSpreadsTheErrorOverTheWay) {
  const Track track = drifting(curve(200, 0.5, 0), {0.05, 0.05, 1e-4});
  const auto mean = loops::drawSegment(track, 0, {tie(0, 200, {102, 0, 0}, 0.01)}, nullptr);
  EXPECT_NEAR(mean.poses.back().x, 102, 0.01);
  // Independent steps: each takes its share.
  for (const std::size_t k : {50u, 100u, 150u})
    EXPECT_NEAR(mean.poses[k - 1].x, 1.02 * track.poses[k].x, 0.02);
}

TEST(Segment, WhatIsClosedAlreadyStaysClosed) {
  // Update 80 came back to update 20; the closure of the end with the beginning must not open that.
  const Track track = curve(120, 0.5, 2 * M_PI / 60);
  const auto held = geometry::relativePose(track.poses[20], track.poses[80]);
  const auto end = geometry::compose(geometry::relativePose(track.poses[0], track.poses[120]),
                                     TPose2D(0.8, 0.4, 0));
  const auto mean =
      loops::drawSegment(track, 0, {tie(20, 80, held, 0.02), tie(0, 120, end, 0.05)}, nullptr);
  const auto after = geometry::relativePose(mean.poses[19], mean.poses[79]);
  EXPECT_LT(off(after, held), 0.05);
  EXPECT_LT(off(geometry::relativePose(track.poses[0], mean.poses[119]), end), 0.1);
}

TEST(Segment, ARigidMotionOfAllChangesNothing) {
  const TPose2D moved(12, -7, 2.1);
  const Track a = curve(80, 0.4, 0.05);
  const Track b = curve(80, 0.4, 0.05, moved);
  const auto relative =
      geometry::compose(geometry::relativePose(a.poses[0], a.poses[80]), {0.5, -0.3, 0.1});
  core::RandomStream rng_a(1, 2, 3, core::Purpose::test), rng_b(1, 2, 3, core::Purpose::test);
  const auto sample_a = loops::drawSegment(a, 0, {tie(0, 80, relative, 0.05)}, &rng_a);
  const auto sample_b = loops::drawSegment(b, 0, {tie(0, 80, relative, 0.05)}, &rng_b);
  for (std::size_t k = 0; k < sample_a.poses.size(); ++k)
    EXPECT_LT(off(geometry::compose(moved, sample_a.poses[k]), sample_b.poses[k]), 1e-6);
}

// A straight way with noise along alone and both ends known is a Brownian bridge: its middle has a
// quarter of the variance of the whole way. Over 600 samples a standard deviation is known to 3 %:
// bounds of four of these.
TEST(Segment, SamplesHaveTheMeanAndSpreadOfTheClosedForm) {
  const Track track = drifting(curve(100, 1, 0), {0.05, 1e-4, 1e-5});
  const int samples = 600;
  double sum = 0, squares = 0;
  for (int i = 0; i < samples; ++i) {
    core::RandomStream rng(7, static_cast<std::uint32_t>(i), 0, core::Purpose::test);
    const auto s = loops::drawSegment(track, 0, {tie(0, 100, {101, 0, 0}, 1e-3)}, &rng);
    sum += s.poses[49].x;
    squares += s.poses[49].x * s.poses[49].x;
  }
  const double mean = sum / samples;
  const double sigma = std::sqrt(squares / samples - mean * mean);
  const double expected = 0.05 * std::sqrt(100.0) / 2;
  EXPECT_NEAR(mean, 50.5, 4 * expected / std::sqrt(static_cast<double>(samples)));
  EXPECT_NEAR(sigma, expected, 0.12 * expected);
}

// A path that an earlier closure drew with its own noise: the next draw goes by what was measured,
// or each closure would add the whole noise once more.
TEST(Segment, WhatWasBentBeforeIsDrawnFromTheMeasuredMotions) {
  const Track straight = drifting(curve(100, 1, 0), {0.05, 0.05, 0.1});
  Track bent = straight;
  for (std::size_t k = 0; k <= 100; ++k)
    bent.poses[k].y = 2 * std::sin(M_PI * static_cast<double>(k) / 100);
  const std::vector<loops::Tie> ties = {tie(0, 100, {101, 0, 0}, 0.05)};
  const auto expected = loops::drawSegment(straight, 0, ties, nullptr);
  const auto mean = loops::drawSegment(bent, 0, ties, nullptr);
  for (std::size_t k = 0; k < 100; ++k) EXPECT_LT(off(mean.poses[k], expected.poses[k]), 1e-3);
  EXPECT_NEAR(mean.cost, expected.cost, 1e-3);
}

TEST(Segment, DriftGrowsWithTheWayAndSwingsAboutTurns) {
  const Track track = drifting(curve(100, 1, 0), {0.03, 0.02, 0.3});
  const auto since = loops::driftSinceEach(track);
  EXPECT_NEAR(since[0](0, 0), 0.03 * 0.03 * 100, 1e-3);
  const double turn = 0.3 * M_PI / 180;
  // Sum of (metres to the end)^2 after each step.
  EXPECT_NEAR(since[0](1, 1), 0.02 * 0.02 * 100 + turn * turn * 328350, 0.2);
  EXPECT_NEAR(since[100](0, 0), 0, 1e-12);
}
