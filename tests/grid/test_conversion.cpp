#include <gtest/gtest.h>

#include "ariadne/core/error.h"
#include "ariadne/grid/map/conversion.h"
#include "scans.h"

using namespace ariadne;
using grid::OccupancyGrid;

TEST(Conversion, MrptHasEveryCellInItsPlace) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  core::RandomStream rng(6, 0, 0, core::Purpose::test);
  for (int i = 0; i < 10; ++i)
    map.insert(grid::makeScanShape(test::randomScan(i), params), test::randomPose(rng));
  const auto mrpt_map = grid::toMrpt(map);
  const auto box = map.knownBox();
  ASSERT_EQ(mrpt_map.getSizeX(), static_cast<unsigned>(box.x1 - box.x0));
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) {
      EXPECT_EQ(mrpt_map.getRow(y - box.y0)[x - box.x0], map.at({x, y}));
      const auto p = map.centreOf({x, y});
      EXPECT_EQ(mrpt_map.x2idx(p.x), x - box.x0);
      EXPECT_EQ(mrpt_map.y2idx(p.y), y - box.y0);
    }
}

TEST(Conversion, ThereAndBackIsTheSameMap) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  core::RandomStream rng(6, 0, 0, core::Purpose::test);
  for (int i = 0; i < 10; ++i)
    map.insert(grid::makeScanShape(test::randomScan(i), params), test::randomPose(rng, 20));
  const OccupancyGrid back = grid::fromMrpt(grid::toMrpt(map), params);
  EXPECT_DOUBLE_EQ(back.resolution(), map.resolution());
  EXPECT_EQ(back.origin().x, 0);
  const auto box = map.knownBox();
  for (int y = box.y0 - 8; y < box.y1 + 8; ++y)
    for (int x = box.x0 - 8; x < box.x1 + 8; ++x) {
      ASSERT_EQ(back.at({x, y}), map.at({x, y}));
      ASSERT_EQ(back.fieldAt({x, y}), map.fieldAt({x, y}));
    }
}

TEST(Conversion, EveryValueOfACellSurvives) {
  mrpt::maps::COccupancyGridMap2D from(-3.2f, 3.2f, 1.0f, 2.0f, 0.1f);
  for (unsigned x = 0; x < from.getSizeX(); ++x)
    for (unsigned y = 0; y < from.getSizeY(); ++y)
      from.getRow(static_cast<int>(y))[x] = static_cast<std::int8_t>((x * 10 + y) % 256 - 128);
  const auto ours = grid::fromMrpt(from);
  for (unsigned x = 0; x < from.getSizeX(); ++x)
    for (unsigned y = 0; y < from.getSizeY(); ++y)
      EXPECT_EQ(ours.at(ours.cellOf({from.idx2x(x), from.idx2y(y)})),
                from.getRow(static_cast<int>(y))[x]);
}

TEST(Conversion, AnEmptyMapIsOneUnknownCell) {
  const auto mrpt_map = grid::toMrpt(OccupancyGrid());
  EXPECT_EQ(mrpt_map.getSizeX(), 1U);
  EXPECT_EQ(mrpt_map.getRow(0)[0], 0);
}

TEST(Conversion, AMapTooWideForADenseGridIsAnError) {
  OccupancyGrid map;
  map.set({0, 0}, 1);
  map.set({200000, 200000}, 1);
  EXPECT_THROW(grid::toMrpt(map), core::Error);
}
