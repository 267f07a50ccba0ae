#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>

#include "ariadne/core/error.h"
#include "ariadne/io/map_files.h"

namespace fs = std::filesystem;
namespace io = ariadne::io;
using Grid = mrpt::maps::COccupancyGridMap2D;

class MapFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("ariadne-map-files-" + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  /// 64 x 20 cells of 0.05 m off the origin, with every value that a cell can take.
  static Grid everyValue() {
    Grid map(-7.35f, -4.15f, 2.6f, 3.6f, 0.05f);
    for (unsigned y = 0; y < map.getSizeY(); ++y)
      for (unsigned x = 0; x < map.getSizeX(); ++x)
        map.getRow(static_cast<int>(y))[x] =
            static_cast<Grid::cellType>(static_cast<int>(y * map.getSizeX() + x) % 255 - 127);
    return map;
  }
  static int state(int log_odds) { return (log_odds > 0) - (log_odds < 0); }

  fs::path folder;
};

TEST_F(MapFiles, RosMapLoadsAgainInPlaceWithEveryState) {
  const Grid map = everyValue();
  io::writeRosMap(folder / "map.pgm", map);
  Grid back;
  ASSERT_TRUE(back.loadFromROSMapServerYAML((folder / "map.yaml").string()));
  ASSERT_EQ(back.getSizeX(), map.getSizeX());
  ASSERT_EQ(back.getSizeY(), map.getSizeY());
  EXPECT_NEAR(back.getXMin(), map.getXMin(), 1e-4);
  EXPECT_NEAR(back.getYMin(), map.getYMin(), 1e-4);
  EXPECT_FLOAT_EQ(back.getResolution(), map.getResolution());
  for (unsigned y = 0; y < map.getSizeY(); ++y)
    for (unsigned x = 0; x < map.getSizeX(); ++x) {
      const int before = state(map.getRow(static_cast<int>(y))[x]);
      const float p = back.getCell(static_cast<int>(x), static_cast<int>(y));
      EXPECT_EQ(p > 0.6 ? 1 : p < 0.4 ? -1 : 0, before) << x << ", " << y;
    }
}

TEST_F(MapFiles, GridmapIsTheSameMap) {
  const Grid map = everyValue();
  io::writeGridmap(folder / "map.gridmap.gz", map);
  mrpt::io::CFileGZInputStream file((folder / "map.gridmap.gz").string());
  auto archive = mrpt::serialization::archiveFrom(file);
  Grid back;
  archive >> back;
  EXPECT_EQ(back.getRawMap(), map.getRawMap());
  EXPECT_EQ(back.getXMin(), map.getXMin());
}

TEST_F(MapFiles, SimplemapIsTheSameMap) {
  mrpt::maps::CSimpleMap map;
  for (int i = 0; i < 3; ++i) {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->resizeScan(5);
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(scan);
    map.insert(mrpt::poses::CPose3DPDFGaussian::Create(mrpt::poses::CPose3D(i, 2, 0, 0, 0, 0)),
               frame);
  }
  io::writeSimplemap(folder / "map.simplemap", map);
  mrpt::maps::CSimpleMap back;
  ASSERT_TRUE(back.loadFromFile((folder / "map.simplemap").string()));
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back.getAsPair(2).pose->getMeanVal().x(), 2);
}

TEST_F(MapFiles, PngShowsNorthUp) {
  Grid map(0, 1, 0, 0.5f, 0.1f);
  map.getRow(4)[2] = 127;   // north
  map.getRow(0)[3] = -127;  // south
  io::writeMapPng(folder / "map.png", map);
  const auto image = mrpt::img::CImage::LoadFromFile((folder / "map.png").string());
  ASSERT_EQ(image.getWidth(), 10U);
  ASSERT_EQ(image.getHeight(), 5U);
  EXPECT_GT(image.getAsFloat(2, 0), 0.95);
  EXPECT_LT(image.getAsFloat(3, 4), 0.05);
  EXPECT_NEAR(image.getAsFloat(0, 0), 0.5, 0.01);
}

TEST_F(MapFiles, APathThatCannotBeWrittenIsNamed) {
  const Grid map = everyValue();
  for (const auto& write : std::vector<std::function<void(const fs::path&)>>{
           [&](const fs::path& p) { io::writeMapPng(p, map); },
           [&](const fs::path& p) { io::writeRosMap(p, map); },
           [&](const fs::path& p) { io::writeGridmap(p, map); },
           [&](const fs::path& p) { io::writeSimplemap(p, {}); }}) {
    try {
      write(folder / "none" / "map.x");
      FAIL();
    } catch (const ariadne::core::Error& e) {
      EXPECT_NE(std::string(e.what()).find("none/map.x"), std::string::npos) << e.what();
    }
  }
}
