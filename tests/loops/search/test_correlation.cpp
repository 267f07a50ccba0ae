#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/loops/search/correlation.h"
#include "ariadne/loops/search/track.h"

using namespace ariadne;
using loops::HitRaster;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

namespace {

/// Walls of a room without symmetry, a point every 0.1 m.
std::vector<TPoint2D> walls() {
  std::vector<TPoint2D> points;
  for (double x = 0; x < 8; x += 0.1) points.emplace_back(x, 0);
  for (double y = 0; y < 5; y += 0.1) points.emplace_back(0, y);
  for (double x = 0; x < 3; x += 0.1) points.emplace_back(x, 5);
  for (double y = 3; y < 5; y += 0.1) points.emplace_back(3, y);
  return points;
}

HitRaster rasterOf(const std::vector<TPoint2D>& points) {
  HitRaster raster({4, 2}, 25, 0.2);
  for (const TPoint2D& p : points) raster.mark(p);
  return raster;
}

/// The room as a robot at `pose` sees it.
std::vector<TPoint2D> seenFrom(const TPose2D& pose) {
  std::vector<TPoint2D> piece;
  for (const TPoint2D& p : walls()) {
    const auto local = pose.inverseComposePoint(p);
    piece.push_back(local);
  }
  return piece;
}

}  // namespace

TEST(Correlation, FindsThePoseWithinACellAndATurnStep) {
  const HitRaster raster = rasterOf(walls());
  const TPose2D truth(4.3, 2.1, 0.4);
  const auto modes =
      loops::correlate(raster, seenFrom(truth), {2.5, 4.0, 0.25}, {4, 0.35}, 0.013, 0.9, 2);
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_LT(std::hypot(modes[0].map_from_piece.x - truth.x, modes[0].map_from_piece.y - truth.y),
            0.25);
  // A cell of 0.2 m at 5 m is 0.04 rad.
  EXPECT_NEAR(modes[0].map_from_piece.phi, truth.phi, 0.04);
  EXPECT_GT(modes[0].hit_share, 0.75);
  EXPECT_LT(modes[1].hit_share, 0.8 * modes[0].hit_share);
  EXPECT_FALSE(modes[0].at_edge);
}

TEST(Correlation, SaysWhenThePlaceMayLieOutsideTheWindow) {
  const HitRaster raster = rasterOf(walls());
  const auto modes =
      loops::correlate(raster, seenFrom({4, 2, 0}), {2.1, 2, 0}, {1.8, 0.1}, 0.013, 0.9, 1);
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_TRUE(modes[0].at_edge);
}

TEST(Correlation, TwoRoomsAlikeAreTwoPlaces) {
  std::vector<TPoint2D> both = walls();
  for (const TPoint2D& p : walls()) both.emplace_back(p.x + 9, p.y);
  const auto modes =
      loops::correlate(rasterOf(both), seenFrom({4, 2, 0}), {8, 2, 0}, {6, 0.05}, 0.013, 0.9, 2);
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_GT(modes[1].hit_share, 0.95 * modes[0].hit_share);
  EXPECT_NEAR(std::abs(modes[0].map_from_piece.x - modes[1].map_from_piece.x), 9, 0.3);
}

TEST(Correlation, RefusesMorePointsThanABytesCount) {
  const std::vector<TPoint2D> many(256);
  EXPECT_THROW(loops::correlate(rasterOf(walls()), many, {}, {1, 0.1}, 0.01, 0.9, 1),
               std::invalid_argument);
}
