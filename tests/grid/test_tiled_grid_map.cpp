#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include "ariadne/grid/map/tiled_grid_map.h"
#include "scans.h"

using namespace ariadne;
using grid::TiledGridMap;
using mrpt::poses::CPose3D;

namespace {

TiledGridMap sample() {
  TiledGridMap map;
  for (int i = 0; i < 5; ++i) {
    auto scan = test::randomScan(i);
    map.insertObservation(scan, CPose3D(0.1 * i, 0, 0, 0.2 * i, 0, 0));
  }
  return map;
}

}  // namespace

TEST(TiledGridMap, AnIniCanNameIt) {
  grid::registerTiledGridMap();
  mrpt::config::CConfigFileMemory ini;
  ini.write("maps", "tiledGrid_count", 1);
  ini.write("maps_tiledGrid_00_creationOpts", "resolution", 0.1);
  ini.write("maps_tiledGrid_00_insertOpts", "maxDistanceInsertion", 12.0);
  mrpt::maps::TSetOfMetricMapInitializers initializers;
  initializers.loadFromConfigFile(ini, "maps");
  ASSERT_EQ(initializers.size(), 1U);
  mrpt::maps::CMultiMetricMap maps;
  maps.setListOfMaps(initializers);
  const auto map = maps.mapByClass<TiledGridMap>();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->params().resolution_m, 0.1);
  EXPECT_EQ(map->params().insert_range_m, 12);
}

TEST(TiledGridMap, SerialisesCellByCell) {
  const TiledGridMap map = sample();
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  archive << map;
  memory.Seek(0);
  TiledGridMap back;
  archive >> back;
  const auto box = map.grid().knownBox();
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) ASSERT_EQ(back.grid().at({x, y}), map.grid().at({x, y}));
}

TEST(TiledGridMap, TheScanFitsBestWhereItWasTaken) {
  const TiledGridMap map = sample();
  const auto scan = test::randomScan(0);
  const double there = map.computeObservationLikelihood(scan, CPose3D());
  EXPECT_GT(there, map.computeObservationLikelihood(scan, CPose3D(0.3, 0.3, 0, 0, 0, 0)));
  EXPECT_GT(there, map.computeObservationLikelihood(scan, CPose3D(0, 0, 0, 0.2, 0, 0)));
}

TEST(TiledGridMap, TakesOnlyScansAlongTheFloor) {
  TiledGridMap map;
  EXPECT_TRUE(map.isEmpty());
  mrpt::obs::CObservationOdometry odometry;
  EXPECT_FALSE(map.insertObservation(odometry));
  auto scan = test::randomScan(0);
  scan.sensorPose = CPose3D(0, 0, 0, 0, 0.5, 0);
  EXPECT_FALSE(map.insertObservation(scan));
  EXPECT_FALSE(map.canComputeObservationLikelihood(scan));
  scan.sensorPose = CPose3D(0, 0, 0, 0, 0, M_PI);
  EXPECT_TRUE(map.insertObservation(scan));
  EXPECT_FALSE(map.isEmpty());
  map.clear();
  EXPECT_TRUE(map.isEmpty());
}

TEST(UpdateCertainty, TakesThreeTimesWhatMrptAdds) {
  grid::GridParams params;
  grid::setUpdateCertainty(params, 0.65);
  const auto evidence = grid::beamEvidence(params);
  EXPECT_EQ(evidence.free, mrpt::maps::COccupancyGridMap2D::p2l(0.65f));
  EXPECT_EQ(evidence.occupied, 3 * evidence.free);
}
