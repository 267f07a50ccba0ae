#include <gtest/gtest.h>

#include <limits>

#include "ariadne/core/error.h"
#include "ariadne/grid/map/conversion.h"
#include "ariadne/grid/map/occupancy_grid.h"
#include "corridor.h"
#include "scans.h"

using namespace ariadne;
using grid::OccupancyGrid;
using grid::PlacedScan;

namespace {

template <class Plane>
void expectSamePlane(const Plane& a, const Plane& b, const char* what) {
  std::size_t differing = 0;
  const auto compare = [&](const Plane& from, const Plane& to) {
    from.forEachTile([&](int tx, int ty, const auto& tile) {
      for (int i = 0; i < static_cast<int>(tile.size()); ++i)
        differing += tile[i] != to.at(tx * grid::kTileCells + i % grid::kTileCells,
                                      ty * Plane::kRows + i / grid::kTileCells);
    });
  };
  compare(a, b);
  compare(b, a);
  EXPECT_EQ(differing, 0U) << what;
}

void expectSame(const OccupancyGrid& a, const OccupancyGrid& b) {
  expectSamePlane(a.cells(), b.cells(), "log odds");
  expectSamePlane(a.field(), b.field(), "field");
}

OccupancyGrid oneByOne(OccupancyGrid map, const std::vector<PlacedScan>& scans) {
  for (const auto& scan : scans) map.insert(*scan.shape, scan.map_from_robot);
  return map;
}

OccupancyGrid atOnce(OccupancyGrid map, const std::vector<PlacedScan>& scans) {
  map.insertMany(scans);
  return map;
}

void expectEqualsOneByOne(const OccupancyGrid& map, const std::vector<PlacedScan>& scans) {
  expectSame(atOnce(map, scans), oneByOne(map, scans));
}

/// Scans of all kinds: lasers off the centre, upside down and behind, few beams, out of range, full
/// turns, readings of nothing.
grid::ScanShape anyShape(std::uint64_t seed, const grid::GridParams& params) {
  core::RandomStream rng(seed, 1, 0, core::Purpose::test);
  auto scan = test::randomScan(seed, 3 + rng.bits() % 200);
  if (rng.uniform() < 0.5)
    scan.sensorPose = mrpt::poses::CPose3D(rng.gaussian(), rng.gaussian(), 0.3, 3 * rng.gaussian(),
                                           0, rng.uniform() < 0.3 ? M_PI : 0);
  if (rng.uniform() < 0.3) scan.aperture = static_cast<float>(2 * M_PI);
  if (rng.uniform() < 0.3) scan.rightToLeft = false;
  const double lost = rng.uniform() < 0.3 ? 1 : 0.2 * rng.uniform();
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
    if (rng.uniform() < lost) {
      scan.setScanRange(i, rng.uniform() < 0.5 ? 0.0f : scan.maxRange);
      scan.setScanRangeValidity(i, false);
    }
  return grid::makeScanShape(scan, params);
}

struct Scans {
  std::vector<grid::ScanShape> shapes;
  std::vector<PlacedScan> placed;
};

/// A random walk: most scans overlap the ones before, some lie far off in any direction.
Scans randomDrive(std::uint64_t seed, std::size_t count, const grid::GridParams& params) {
  core::RandomStream rng(seed, 2, 0, core::Purpose::test);
  Scans scans;
  for (std::size_t i = 0; i < count; ++i) scans.shapes.push_back(anyShape(1000 * seed + i, params));
  mrpt::math::TPose2D pose;
  for (std::size_t i = 0; i < count; ++i) {
    const auto step = test::randomPose(rng, rng.uniform() < 0.05 ? 20 : 0.2);
    pose = {pose.x + step.x, pose.y + step.y, step.phi};
    scans.placed.push_back({&scans.shapes[i], pose});
  }
  return scans;
}

}  // namespace

TEST(InsertMany, EqualsOneByOneOnRandomDrives) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    grid::GridParams params;
    params.no_return_free_m = seed % 3 == 0 ? 2 : 0;
    const auto scans = randomDrive(seed, 60, params);
    expectEqualsOneByOne(OccupancyGrid(params), scans.placed);
  }
}

TEST(InsertMany, EqualsOneByOneRoundACorridor) {
  for (const double heading : {0.0, 0.4}) {
    const auto drive = test::corridorLoop({}, heading);
    expectEqualsOneByOne(OccupancyGrid(), drive.placed());
  }
}

// The planes of counts run full, and evidence takes from one beam to a hundred to saturate.
TEST(InsertMany, EqualsOneByOneForWeakAndStrongEvidence) {
  for (const double free : {0.51, 0.55, 0.9, 0.99})
    for (const double occupied : {0.51, 0.99}) {
      grid::GridParams params;
      params.free_probability = free;
      params.occupied_probability = occupied;
      std::vector<grid::ScanShape> shapes;
      for (int i = 0; i < 7; ++i)
        shapes.push_back(grid::makeScanShape(test::randomScan(i), params));
      std::vector<PlacedScan> scans;
      for (int i = 0; i < 150; ++i) scans.push_back({&shapes[i % 7], {0.01 * (i % 5), 0, 0}});
      expectEqualsOneByOne(OccupancyGrid(params), scans);
    }
}

TEST(InsertMany, EqualsOneByOneForAnyResolutionAndWidth) {
  for (const double resolution : {0.02, 0.1, 0.5})
    for (const double sigma : {0.03, 0.2, 0.7}) {
      grid::GridParams params;
      params.resolution_m = resolution;
      params.field_sigma_m = sigma;
      if (sigma / resolution > 12) continue;  // one by one takes a minute
      const auto scans = randomDrive(5, 12, params);
      expectEqualsOneByOne(OccupancyGrid(params), scans.placed);
    }
}

TEST(InsertMany, GoesOnFromAKnownMapWhoseCopiesStayAsTheyWere) {
  const grid::GridParams params;
  const auto first = randomDrive(1, 40, params);
  const auto second = randomDrive(2, 40, params);
  const OccupancyGrid original = oneByOne(OccupancyGrid(params), first.placed);
  const OccupancyGrid kept = original;
  expectEqualsOneByOne(original, second.placed);
  expectSame(original, kept);
  expectSame(original, oneByOne(OccupancyGrid(params), first.placed));
}

TEST(InsertMany, TilesThatDoNotChangeStayShared) {
  const auto shape = grid::makeScanShape(test::randomScan(1), {});
  const OccupancyGrid saturated =
      oneByOne(OccupancyGrid(), std::vector<PlacedScan>(40, {&shape, {0, 0, 0}}));
  const OccupancyGrid again = atOnce(saturated, std::vector<PlacedScan>(40, {&shape, {0, 0, 0}}));
  saturated.cells().forEachPacked(
      [&](int tx, int ty, const auto& tile) { EXPECT_EQ(again.cells().tile(tx, ty), &tile); });
}

// MRPT's cells may hold -128, which no evidence of ours reaches.
TEST(InsertMany, GoesOnFromAnImportedMap) {
  mrpt::maps::COccupancyGridMap2D from(-3.2f, 3.2f, -3.0f, 3.0f, 0.05f);
  for (unsigned y = 0; y < from.getSizeY(); ++y)
    for (unsigned x = 0; x < from.getSizeX(); ++x)
      from.getRow(static_cast<int>(y))[x] = static_cast<std::int8_t>((x * 7 + y * 31) % 256 - 128);
  const auto scans = randomDrive(3, 60, {});
  expectEqualsOneByOne(grid::fromMrpt(from), scans.placed);
}

// Over 1.6 km apart, scans go in by parts.
TEST(InsertMany, EqualsOneByOneWhereScansAreFarApart) {
  auto scans = randomDrive(4, 30, {});
  for (std::size_t i = 0; i < scans.placed.size(); ++i)
    if (i / 5 % 2 == 1) scans.placed[i].map_from_robot.x -= 2000;
  for (std::size_t i = 0; i < scans.placed.size(); ++i)
    if (i / 7 % 2 == 1) scans.placed[i].map_from_robot.y += 1500;
  expectEqualsOneByOne(OccupancyGrid(), scans.placed);
}

TEST(InsertMany, NothingChangesNothing) {
  const auto empty = grid::makeScanShape(test::scanOf(181, [](std::size_t) { return 0.0; }), {});
  const grid::ScanShape none;
  OccupancyGrid map;
  map.insertMany({});
  map.insertMany({{&empty, {1, 2, 3}}, {&none, {0, 0, 0}}});
  EXPECT_TRUE(map.knownBox().empty());
}

TEST(InsertMany, APoseThatIsNoPlaceIsAnErrorAndChangesNothing) {
  const auto scans = randomDrive(6, 10, {});
  const OccupancyGrid before = oneByOne(OccupancyGrid(), scans.placed);
  OccupancyGrid map = before;
  for (const mrpt::math::TPose2D& bad :
       {mrpt::math::TPose2D(std::nan(""), 0, 0), mrpt::math::TPose2D(0, 0, INFINITY),
        mrpt::math::TPose2D(1e30, 0, 0)}) {
    auto list = scans.placed;
    list.push_back({list[0].shape, bad});
    EXPECT_THROW(map.insertMany(list), core::Error);
    expectSame(map, before);
  }
}

TEST(InsertMany, ARunawayPoseIsAnErrorAndTheFieldStillBelongsToTheMap) {
  auto scans = randomDrive(7, 10, {});
  scans.placed[5].map_from_robot = {4e6, 4e6, 0};
  OccupancyGrid map;
  EXPECT_THROW(map.insertMany(scans.placed), core::Error);
  OccupancyGrid again;  // cell by cell, so that the field follows each
  map.cells().forEachTile([&](int tx, int ty, const auto& tile) {
    for (int i = 0; i < static_cast<int>(tile.size()); ++i)
      again.set({tx * grid::kTileCells + i % grid::kTileCells,
                 ty * grid::kTileCells + i / grid::kTileCells},
                tile[i]);
  });
  expectSame(map, again);
}

TEST(InsertMany, AShapeThatIsNotFiniteIsAnError) {
  OccupancyGrid map;
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e12}) {
    const grid::ScanShape outline{{{0, 0}, {1, 0}, {bad, 1}}, {}};
    const grid::ScanShape hit{{}, {{bad, 0}}};
    for (const auto* shape : {&outline, &hit}) {
      EXPECT_THROW(map.insert(*shape, {0, 0, 0}), core::Error);
      EXPECT_THROW(map.insertMany({{shape, {0, 0, 0}}}), core::Error);
    }
  }
  EXPECT_TRUE(map.knownBox().empty());
}
