#include <gtest/gtest.h>

#include "recapture.h"
#include "room.h"

using namespace ariadne;
using mrpt::math::TPoint2D;

namespace {

/// Ends of beams that are seen from (0.3, 0.2, 0): two of three on the walls of the room, the
/// others in free space.
std::vector<TPoint2D> mostlyOnWalls(std::size_t count) {
  const mrpt::math::TPose2D pose(0.3, 0.2, 0);
  const auto all = grid::scanPoints(*test::scanIn(test::roomWorld(), pose), 20);
  std::vector<TPoint2D> points;
  for (std::size_t i = 0; i < count; ++i) {
    const TPoint2D end = all[i * all.size() / count];
    points.push_back(i % 3 < 2 ? end : end * 0.6);
  }
  return points;
}

}  // namespace

// Two thirds of 25 endpoints is what chance finds somewhere; of 180 it is not.
TEST(Recapture, OfFewEndpointsMoreIsAsked) {
  const slam::Recapture recapture({}, 8);
  filter::Particle particle;
  particle.map = test::roomMap();
  slam::Doubt doubt;
  doubt.blind = true;
  doubt.covariance = Eigen::Matrix3d::Identity() * 0.04;
  const mrpt::math::TPose2D expected(0.4, 0.1, 0.05);
  using By = slam::Recaptured::By;
  const auto few = recapture(particle, mostlyOnWalls(25), expected, doubt);
  EXPECT_EQ(few.by, By::odometry);
  EXPECT_EQ(few.motion, expected);
  const auto many = recapture(particle, mostlyOnWalls(180), expected, doubt);
  EXPECT_EQ(many.by, By::scan);
  EXPECT_NEAR(many.motion.x, 0.3, 0.05);  // a cell
  EXPECT_NEAR(many.motion.y, 0.2, 0.05);
}

// Too few endpoints to be sure by: of where the odometry jumped to and where the robot would be had
// it gone on as before, it is the place where the scan lies better.
TEST(Recapture, AGuessIsWhereTheScanLiesBetter) {
  const slam::Recapture recapture({}, 8);
  filter::Particle particle;
  particle.map = test::roomMap();
  slam::Doubt doubt;
  doubt.claimed = mrpt::math::TPose2D(0.32, 0.2, 0);
  const auto guess = recapture(particle, mostlyOnWalls(25), {-1.4, -0.6, 0.5}, doubt);
  EXPECT_EQ(guess.by, slam::Recaptured::By::guess);
  EXPECT_NEAR(guess.motion.x, 0.3, 0.1);
  EXPECT_NEAR(guess.motion.y, 0.2, 0.1);
}
