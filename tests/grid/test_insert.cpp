#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "ariadne/core/error.h"
#include "ariadne/grid/map/occupancy_grid.h"
#include "polygon_rows.h"
#include "scans.h"

using namespace ariadne;
using grid::Cell;
using grid::OccupancyGrid;

namespace {

using Reference = std::map<std::pair<int, int>, int>;

/// The same scan entered cell by cell, in the plainest way.
void insertPlainly(Reference& map, const grid::GridParams& params, const grid::ScanShape& shape,
                   const mrpt::math::TPose2D& pose) {
  const auto evidence = grid::beamEvidence(params);
  const auto toCells = [&](const mrpt::math::TPoint2D& p) {
    const double c = std::cos(pose.phi) / params.resolution_m;
    const double s = std::sin(pose.phi) / params.resolution_m;
    return mrpt::math::TPoint2D(pose.x / params.resolution_m + c * p.x - s * p.y,
                                pose.y / params.resolution_m + s * p.x + c * p.y);
  };
  std::set<std::pair<int, int>> hits;
  for (const auto& p : shape.hits) {
    const auto v = toCells(p);
    hits.insert({static_cast<int>(std::floor(v.x)), static_cast<int>(std::floor(v.y))});
  }
  std::vector<mrpt::math::TPoint2D> outline;
  for (const auto& p : shape.outline) outline.push_back(toCells(p));
  grid::PolygonRows rows;
  rows.build(outline);
  for (int y = rows.firstRow(); y < rows.endRow(); ++y)
    rows.forEachSpan(y, [&](int x0, int x1) {
      for (int x = x0; x < x1; ++x)
        if (hits.count({x, y}) == 0) map[{x, y}] = std::min(127, map[{x, y}] + evidence.free);
    });
  for (const auto& cell : hits) map[cell] = std::max(-127, map[cell] - evidence.occupied);
}

void expectSame(const OccupancyGrid& map, const Reference& reference) {
  std::size_t known = 0;
  for (const auto& [cell, value] : reference) {
    EXPECT_EQ(map.at({cell.first, cell.second}), value) << cell.first << ", " << cell.second;
    known += value != 0;
  }
  std::size_t in_map = 0;
  map.cells().forEachTile([&](int, int, const auto& tile) {
    for (const auto v : tile) in_map += v != 0;
  });
  EXPECT_EQ(in_map, known);
}

}  // namespace

TEST(Insert, EqualsCellByCell) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  Reference reference;
  core::RandomStream rng(11, 0, 0, core::Purpose::test);
  for (int i = 0; i < 25; ++i) {
    const auto shape = grid::makeScanShape(test::randomScan(i), params);
    const auto pose = test::randomPose(rng);
    map.insert(shape, pose);
    insertPlainly(reference, params, shape, pose);
  }
  expectSame(map, reference);
}

// Outlines that no laser makes, which cross themselves: even-odd as ever.
TEST(Insert, EqualsCellByCellForAnyOutline) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  Reference reference;
  core::RandomStream rng(12, 0, 0, core::Purpose::test);
  for (int i = 0; i < 40; ++i) {
    grid::ScanShape shape;
    const auto corners = rng.bits() % 40;
    for (std::uint32_t k = 0; k < corners; ++k) {
      shape.outline.push_back({2 * rng.gaussian(), 2 * rng.gaussian()});
      if (rng.uniform() < 0.3) shape.outline.push_back(shape.outline.back());
      if (rng.uniform() < 0.3) shape.hits.push_back({2 * rng.gaussian(), 2 * rng.gaussian()});
    }
    // Whole and half cells too, where centres lie on edges.
    auto pose = test::randomPose(rng);
    if (i % 2 == 0) {
      pose = {0, 0, 0};
      for (auto& p : shape.outline) p = {std::round(40 * p.x) / 40, std::round(40 * p.y) / 40};
    }
    map.insert(shape, pose);
    insertPlainly(reference, params, shape, pose);
  }
  expectSame(map, reference);
}

TEST(Insert, ACopyIsNotTouched) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  Reference reference;
  const auto first = grid::makeScanShape(test::randomScan(1), params);
  map.insert(first, {0, 0, 0});
  insertPlainly(reference, params, first, {0, 0, 0});
  const OccupancyGrid checkpoint = map;
  map.insert(grid::makeScanShape(test::randomScan(2), params), {0.3, 0.1, 0.5});
  expectSame(checkpoint, reference);
}

// The world moved by whole cells moves the map with it, to the bit.
TEST(Insert, MovedByWholeCells) {
  grid::GridParams params;
  params.resolution_m = 0.0625;  // whole cells are exact numbers
  OccupancyGrid here(params);
  OccupancyGrid there(params);
  core::RandomStream rng(5, 0, 0, core::Purpose::test);
  for (int i = 0; i < 10; ++i) {
    const auto shape = grid::makeScanShape(test::randomScan(i), params);
    auto pose = test::randomPose(rng);
    pose.x = std::round(pose.x * 1024) / 1024;
    pose.y = std::round(pose.y * 1024) / 1024;
    here.insert(shape, pose);
    pose.x += 37 * 0.0625;
    pose.y -= 90 * 0.0625;
    there.insert(shape, pose);
  }
  const auto box = here.knownBox();
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) EXPECT_EQ(here.at({x, y}), there.at({x + 37, y - 90}));
}

TEST(Insert, WallsStayAndRoomsAreFree) {
  const grid::GridParams params;
  OccupancyGrid map(params);
  // A wall 3 m ahead, x = 3, seen ten times.
  const auto wall = test::scanOf(181, [](std::size_t i) {
    const double angle = -M_PI / 2 + M_PI * static_cast<double>(i) / 180;
    return std::min(3 / std::max(std::cos(angle), 1e-3), 20.0);
  });
  for (int i = 0; i < 10; ++i) map.insert(grid::makeScanShape(wall, params), {0.02, 0, 0});
  EXPECT_LT(map.at(map.cellOf({3.02, 0.5})), 0);
  EXPECT_GT(map.at(map.cellOf({1.5, 0.5})), 0);
  EXPECT_EQ(map.at(map.cellOf({3.3, 0.5})), 0);  // behind the wall
  EXPECT_EQ(map.at(map.cellOf({-1, 0.5})), 0);   // behind the robot
}

TEST(Insert, PosesThatAreNoPlaceAreErrors) {
  OccupancyGrid map;
  const auto shape = grid::makeScanShape(test::randomScan(1), {});
  EXPECT_THROW(map.insert(shape, {std::nan(""), 0, 0}), core::Error);
  EXPECT_THROW(map.insert(shape, {0, 0, INFINITY}), core::Error);
  EXPECT_THROW(map.insert(shape, {1e30, 0, 0}), core::Error);
}

TEST(Insert, AScanWithNothingChangesNothing) {
  OccupancyGrid map;
  const auto shape = grid::makeScanShape(test::scanOf(181, [](std::size_t) { return 0.0; }), {});
  map.insert(shape, {0, 0, 0});
  EXPECT_TRUE(map.knownBox().empty());
  map.insert({}, {0, 0, 0});
  EXPECT_TRUE(map.knownBox().empty());
}
