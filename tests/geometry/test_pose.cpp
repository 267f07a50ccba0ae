#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include "ariadne/core/random.h"
#include "ariadne/geometry/pose.h"

using namespace ariadne;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

namespace {

TPose2D drawn(core::RandomStream& rng) {
  return {20 * rng.gaussian(), 20 * rng.gaussian(), 4 * rng.gaussian()};
}

}  // namespace

TEST(Poses, RelativeUndoesCompose) {
  const TPose2D a(1, -2, 2.5);
  const TPose2D b(0.4, 0.7, 1.9);
  const TPose2D c = geometry::relativePose(a, geometry::compose(a, b));
  EXPECT_NEAR(c.x, b.x, 1e-12);
  EXPECT_NEAR(c.y, b.y, 1e-12);
  EXPECT_NEAR(c.phi, b.phi, 1e-12);
}

// Runs are compared by their bits, also with those of before this arithmetic was MRPT's.
TEST(Poses, TheArithmeticIsThisToTheBit) {
  core::RandomStream rng(1, 0, 0, core::Purpose::test);
  for (int i = 0; i < 2000; ++i) {
    const TPose2D a = drawn(rng), b = drawn(rng);
    const double c = std::cos(a.phi), s = std::sin(a.phi), dx = b.x - a.x, dy = b.y - a.y;
    const TPose2D seen = geometry::relativePose(a, b), moved = geometry::compose(a, b);
    ASSERT_EQ(seen.x, c * dx + s * dy);
    ASSERT_EQ(seen.y, -s * dx + c * dy);
    ASSERT_EQ(seen.phi, mrpt::math::wrapToPi(b.phi - a.phi));
    ASSERT_EQ(moved.x, a.x + c * b.x - s * b.y);
    ASSERT_EQ(moved.y, a.y + s * b.x + c * b.y);
    ASSERT_EQ(moved.phi, mrpt::math::wrapToPi(a.phi + b.phi));
  }
}

TEST(Poses, PointsAreThoseOfComposePoint) {
  core::RandomStream rng(2, 0, 0, core::Purpose::test);
  const TPose2D pose = drawn(rng);
  const std::vector<TPoint2D> points{{0, 0}, {1, 2}, {-3.5, 0.25}};
  const auto placed = geometry::placed(pose, points);
  ASSERT_EQ(placed.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(placed[i].x, pose.composePoint(points[i]).x);
    EXPECT_EQ(placed[i].y, pose.composePoint(points[i]).y);
  }
}

TEST(Poses, DistanceIsOfPlacesHoweverTheyAreTurned) {
  EXPECT_DOUBLE_EQ(geometry::distance(TPoint2D(1, 1), TPoint2D(4, 5)), 5);
  EXPECT_DOUBLE_EQ(geometry::distance(TPose2D(1, 1, 2), TPoint2D(4, 5)), 5);
  EXPECT_EQ(geometry::distance(TPose2D(1, 1, 2), TPose2D(1, 1, -2)), 0);
}
