// A batch reads what FieldSampler reads point by point, to the bit.
#include <gtest/gtest.h>

#include "ariadne/grid/field/field_batch.h"
#include "ariadne/grid/field/field_sampler.h"
#include "scans.h"

using namespace ariadne;
using grid::FieldBatch;
using grid::OccupancyGrid;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

namespace {

OccupancyGrid randomMap(std::uint64_t seed, const TPoint2D& origin) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  map.clear(origin);
  core::RandomStream rng(seed, 0, 0, core::Purpose::test);
  for (int i = 0; i < 8; ++i)
    map.insert(grid::makeScanShape(test::randomScan(10 * seed + i), params),
               test::randomPose(rng, 2));
  return map;
}

void expectAsSampled(FieldBatch& batch, const OccupancyGrid& map,
                     const std::vector<TPoint2D>& points, const TPose2D& pose) {
  batch.turn(pose.phi);
  batch.sample({pose.x, pose.y});
  ASSERT_EQ(batch.size(), points.size());
  grid::FieldSampler sampler(map);
  const double c = std::cos(pose.phi);
  const double s = std::sin(pose.phi);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double rx = c * points[i].x - s * points[i].y;
    const double ry = s * points[i].x + c * points[i].y;
    const grid::FieldSample one = sampler.sample(pose.x + rx, pose.y + ry);
    ASSERT_EQ(batch.offsetX()[i], rx);
    ASSERT_EQ(batch.offsetY()[i], ry);
    ASSERT_EQ(batch.value()[i], one.value);
    ASSERT_EQ(batch.dx()[i], one.dx);
    ASSERT_EQ(batch.dy()[i], one.dy);
    sum += sampler.value(pose.x + rx, pose.y + ry);
  }
  ASSERT_EQ(batch.sum({pose.x, pose.y}), sum);
}

}  // namespace

TEST(FieldBatch, EqualsTheSamplerPointByPoint) {
  FieldBatch batch;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const OccupancyGrid map = randomMap(seed, {0.013 * seed, -0.021 * seed});
    // An odd number of points, too.
    const auto points = grid::scanPoints(test::randomScan(seed, 180 + seed), 30);
    batch.use(map, points);
    core::RandomStream rng(seed, 0, 0, core::Purpose::test);
    TPose2D pose;
    for (int i = 0; i < 40; ++i) {
      // Far from the one before, then nearer and nearer, as a match goes.
      const double step = std::pow(0.3, i % 8);
      pose = {pose.x + step * rng.gaussian(), pose.y + step * rng.gaussian(),
              pose.phi + step * rng.gaussian()};
      expectAsSampled(batch, map, points, pose);
    }
  }
}

TEST(FieldBatch, IsOfTheMapAsItIsWhenUsed) {
  OccupancyGrid map = randomMap(1, {0, 0});
  const auto points = grid::scanPoints(test::randomScan(3), 30);
  FieldBatch batch;
  batch.use(map, points);
  expectAsSampled(batch, map, points, {0, 0, 0});
  map.insert(grid::makeScanShape(test::randomScan(3), {}), {0, 0, 0});
  batch.use(map, points);
  expectAsSampled(batch, map, points, {0, 0, 0});
}

TEST(FieldBatch, NothingIsReadOfNothing) {
  const OccupancyGrid map;
  const std::vector<TPoint2D> none;
  FieldBatch batch;
  batch.use(map, none);
  expectAsSampled(batch, map, none, {1, 2, 3});
}

TEST(FieldBatch, FarAwayAndNoNumberReadZero) {
  const OccupancyGrid map = randomMap(2, {0, 0});
  const auto points = grid::scanPoints(test::randomScan(4), 30);
  FieldBatch batch;
  batch.use(map, points);
  const double nan = std::nan("");
  for (const TPose2D& pose :
       {TPose2D(1e12, 0, 0), TPose2D(0, -1e12, 0), TPose2D(nan, 0, 0), TPose2D(0, HUGE_VAL, 0),
        TPose2D(0, 0, nan), TPose2D(0, 0, HUGE_VAL)}) {
    batch.turn(pose.phi);
    EXPECT_EQ(batch.sum({pose.x, pose.y}), 0);
    batch.sample({pose.x, pose.y});
    for (std::size_t i = 0; i < batch.size(); ++i) EXPECT_EQ(batch.value()[i], 0);
  }
  expectAsSampled(batch, map, points, {0, 0, 0});
}
