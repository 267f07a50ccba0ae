#include <gtest/gtest.h>

#include "ariadne/grid/field/field_sampler.h"
#include "ariadne/grid/map/occupancy_grid.h"
#include "scans.h"

using namespace ariadne;
using grid::Cell;
using grid::OccupancyGrid;

namespace {

/// The definition: every occupied cell gives its neighbourhood the kernel, the highest counts.
void expectFieldAsDefined(const OccupancyGrid& map, const grid::GridParams& params) {
  const grid::FieldKernel kernel(params.field_sigma_m / params.resolution_m);
  const int r = kernel.radius();
  const auto box = map.knownBox();
  for (int y = box.y0 - r; y < box.y1 + r; ++y)
    for (int x = box.x0 - r; x < box.x1 + r; ++x) {
      int expected = 0;
      for (int dy = -r; dy <= r; ++dy)
        for (int dx = -r; dx <= r; ++dx)
          if (map.at({x + dx, y + dy}) < 0) expected = std::max<int>(expected, kernel.at(dx, dy));
      ASSERT_EQ(map.fieldAt({x, y}), expected) << x << ", " << y;
    }
}

}  // namespace

TEST(LikelihoodField, EqualsItsDefinitionAfterManyScans) {
  for (const double sigma : {0.07, 0.15, 0.3}) {
    grid::GridParams params;
    params.field_sigma_m = sigma;
    OccupancyGrid map(params);
    core::RandomStream rng(2, 0, 0, core::Purpose::test);
    for (int i = 0; i < 12; ++i)
      map.insert(grid::makeScanShape(test::randomScan(i, 91), params), test::randomPose(rng, 1));
    expectFieldAsDefined(map, params);
  }
}

TEST(LikelihoodField, FollowsSingleCells) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  core::RandomStream rng(9, 0, 0, core::Purpose::test);
  for (int i = 0; i < 600; ++i)
    map.set({static_cast<int>(rng.bits() % 40), static_cast<int>(rng.bits() % 40) - 20},
            rng.uniform() < 0.5 ? -10 : 10);
  expectFieldAsDefined(map, params);
}

// In a field this wide the cell beside an occupied one holds 255 too, and was once taken for
// occupied already: the field depended on the order of changes.
TEST(LikelihoodField, AWideFieldReachesAsFarFromEveryCell) {
  grid::GridParams params;
  params.resolution_m = 0.01;
  params.field_sigma_m = 0.2;
  const grid::FieldKernel kernel(20);
  ASSERT_EQ(kernel.along(1), 255);
  OccupancyGrid map(params);
  map.set({0, 0}, -10);
  map.set({1, 0}, -10);
  EXPECT_GT(kernel.along(kernel.radius()), 0);
  EXPECT_EQ(map.fieldAt({1 + kernel.radius(), 0}), kernel.along(kernel.radius()));
  EXPECT_EQ(map.fieldAt({-kernel.radius(), 0}), kernel.along(kernel.radius()));
}

TEST(LikelihoodField, KernelIsAGaussianToHalfAStep) {
  const double sigma = 2;
  const grid::FieldKernel kernel(sigma);
  EXPECT_EQ(kernel.at(0, 0), 255);
  for (int dy = -kernel.radius(); dy <= kernel.radius(); ++dy)
    for (int dx = -kernel.radius(); dx <= kernel.radius(); ++dx)
      // Two factors rounded to 1/255 each, and their product once more.
      EXPECT_NEAR(kernel.at(dx, dy), 255 * std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)),
                  1.5);
}

TEST(FieldSampler, IsTheCellAtItsCentreAndLinearBetween) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  map.set({31, 31}, -50);  // on the corner of four tiles
  grid::FieldSampler field(map);
  for (int y = 27; y < 36; ++y)
    for (int x = 27; x < 36; ++x) {
      const auto p = map.centreOf({x, y});
      EXPECT_NEAR(field.value(p.x, p.y), map.fieldAt({x, y}), 1e-6);
      const auto q = map.centreOf({x + 1, y});
      EXPECT_NEAR(field.value((p.x + q.x) / 2, p.y),
                  (map.fieldAt({x, y}) + map.fieldAt({x + 1, y})) / 2.0, 1e-6);
    }
}

TEST(FieldSampler, GradientIsTheSlope) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  core::RandomStream rng(4, 0, 0, core::Purpose::test);
  for (int i = 0; i < 30; ++i)
    map.set({static_cast<int>(rng.bits() % 50), static_cast<int>(rng.bits() % 50)}, -50);
  grid::FieldSampler field(map);
  for (int i = 0; i < 200; ++i) {
    const double x = 2.5 * rng.uniform();
    const double y = 2.5 * rng.uniform();
    const double h = 1e-6;  // stays within one cell nearly always; bilinear is exact there
    const auto s = field.sample(x, y);
    const auto slope = [&](double dx, double dy) {
      return (field.value(x + dx, y + dy) - field.value(x - dx, y - dy)) / (2 * h * 255);
    };
    EXPECT_NEAR(s.dx, slope(h, 0), 1e-3);
    EXPECT_NEAR(s.dy, slope(0, h), 1e-3);
    EXPECT_NEAR(s.value, field.value(x, y) / 255, 1e-12);
  }
}

TEST(FieldSampler, FarAwayAndNoNumberReadZero) {
  OccupancyGrid map;
  map.set({0, 0}, -50);
  grid::FieldSampler field(map);
  for (const double v : {1e12, -1e12, std::nan(""), HUGE_VAL}) EXPECT_EQ(field.value(v, 0), 0);
}
