#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>
#include <sys/resource.h>

#include <csignal>
#include <functional>
#include <iterator>
#include <random>

#include "ariadne/core/error.h"
#include "ariadne/io/map_files.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

namespace fs = std::filesystem;
namespace io = ariadne::io;
using Grid = mrpt::maps::COccupancyGridMap2D;

class MapFiles : public TemporaryFolder {
 protected:
  /// 199 x 155 cells of 0.05 m off the origin, with every int8 value.
  static Grid everyValue(float resolution_m = 0.05f) {
    Grid map(-7.35f, 2.6f, -4.15f, 3.6f, resolution_m);
    int n = 0;
    for (unsigned y = 0; y < map.getSizeY(); ++y)
      for (unsigned x = 0; x < map.getSizeX(); ++x)
        map.getRow(static_cast<int>(y))[x] = static_cast<Grid::cellType>(n++ % 256 - 128);
    return map;
  }

  void expectSameFromRos(const Grid& map, const std::string& stem) {
    io::writeRosMap(folder / (stem + ".pgm"), map);
    Grid back;
    ASSERT_TRUE(back.loadFromROSMapServerYAML((folder / (stem + ".yaml")).string()));
    ASSERT_EQ(back.getSizeX(), map.getSizeX());
    ASSERT_EQ(back.getSizeY(), map.getSizeY());
    // MRPT computes in float: a few of its roundings at 7 m.
    EXPECT_NEAR(back.getXMin(), map.getXMin(), 2e-6);
    EXPECT_NEAR(back.getYMin(), map.getYMin(), 2e-6);
    EXPECT_EQ(back.getResolution(), map.getResolution());
    for (unsigned y = 0; y < map.getSizeY(); ++y)
      for (unsigned x = 0; x < map.getSizeX(); ++x)
        // Trinary: the loader makes cells surely free, surely occupied or exactly unknown.
        ASSERT_EQ(state(back.getRow(static_cast<int>(y))[x]),
                  state(map.getRow(static_cast<int>(y))[x]))
            << x << ", " << y;
  }
  static int state(int log_odds) { return (log_odds > 0) - (log_odds < 0); }

  static std::vector<std::function<void(const fs::path&)>> writersOf(const Grid& map) {
    return {[&map](const fs::path& p) { io::writeMapPng(p, map); },
            [&map](const fs::path& p) { io::writeRosMap(p, map); },
            [&map](const fs::path& p) { io::writeGridmap(p, map); }};
  }
};

namespace {

/// Every file of this process is full at `bytes`: what a full disk looks like to a writer.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

mrpt::maps::CSimpleMap someFrames(int count, std::size_t beams) {
  mrpt::maps::CSimpleMap map;
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i) {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->resizeScan(beams);
    for (std::size_t k = 0; k < beams; ++k)
      scan->setScanRange(k, static_cast<float>(random() % 8000) / 1000);
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(scan);
    map.insert(mrpt::poses::CPose3DPDFGaussian::Create(mrpt::poses::CPose3D(i, 2, 0, 0, 0, 0)),
               frame);
  }
  return map;
}

/// What the error says; fails the test when there is none.
std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const ariadne::core::Error& e) {
    return e.what();
  }
  ADD_FAILURE() << "no core::Error";
  return {};
}

}  // namespace

TEST_F(MapFiles, RosMapLoadsAgainInPlaceWithEveryState) {
  // A third of 0.1 m has no short decimal.
  for (const float resolution_m : {0.05f, 0.1f, 0.03f, 0.1f / 3})
    expectSameFromRos(everyValue(resolution_m), "map");
}

TEST_F(MapFiles, RosMapOfOneCellAndOfAnOddNameLoadsAgain) {
  Grid map(0.2f, 0.3f, -0.1f, 0, 0.1f);
  ASSERT_EQ(map.getRawMap().size(), 1U);
  for (const int cell : {-128, -1, 0, 1, 127}) {
    map.getRow(0)[0] = static_cast<Grid::cellType>(cell);
    expectSameFromRos(map, "floor #2: \"B\"");
  }
}

TEST_F(MapFiles, RosPixelsAreThoseOfMapServer) {
  Grid map(0, 0.3f, 0, 0.2f, 0.1f);
  map.getRow(1)[0] = 1;
  map.getRow(1)[1] = -1;
  io::writeRosMap(folder / "map.pgm", map);
  EXPECT_EQ(io::readWhole(folder / "map.pgm"),
            "P5\n3 2\n255\n\xFE" + std::string(1, '\0') + "\xCD\xCD\xCD\xCD");
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
  const auto map = someFrames(3, 5);
  io::writeSimplemap(folder / "map.simplemap", map);
  mrpt::maps::CSimpleMap back;
  ASSERT_TRUE(back.loadFromFile((folder / "map.simplemap").string()));
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(std::next(back.begin(), 2)->pose->getMeanVal().x(), 2);
  const auto scan_of = [](const mrpt::maps::CSimpleMap& m) {
    return std::next(m.begin())->sf->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
  };
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_EQ(scan_of(back)->getScanRange(k), scan_of(map)->getScanRange(k));
}

TEST_F(MapFiles, SimplemapWithoutFramesLoadsAgain) {
  io::writeSimplemap(folder / "map.simplemap", {});
  mrpt::maps::CSimpleMap back = someFrames(1, 1);
  ASSERT_TRUE(back.loadFromFile((folder / "map.simplemap").string()));
  EXPECT_EQ(back.size(), 0U);
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

TEST_F(MapFiles, AMapWithoutCellsIsRefusedByName) {
  Grid map;
  map.setSize(0, 0.02f, 0, 0.02f, 0.1f);
  ASSERT_EQ(map.getRawMap().size(), 0U);
  for (const auto& write : writersOf(map)) {
    const std::string error = errorOf([&] { write(folder / "map.x"); });
    EXPECT_NE(error.find("map.x: the map has no cells"), std::string::npos) << error;
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(MapFiles, APictureTooWideForPngIsRefusedByName) {
  const Grid map(0, 100010, 0, 0.1f, 0.1f);
  const std::string error = errorOf([&] { io::writeMapPng(folder / "map.png", map); });
  EXPECT_NE(error.find("map.png, 1000100 x 1 cells"), std::string::npos) << error;
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(MapFiles, APathThatCannotBeWrittenIsNamed) {
  const Grid map = everyValue();
  io::writeWhole(folder / "file", "text");
  auto writers = writersOf(map);
  writers.emplace_back([](const fs::path& p) { io::writeSimplemap(p, {}); });
  for (const auto& write : writers)
    for (const char* where : {"none/map.x", "file/map.x"}) {
      const std::string error = errorOf([&] { write(folder / where); });
      EXPECT_NE(error.find(where), std::string::npos) << error;
    }
  EXPECT_EQ(io::readWhole(folder / "file"), "text");
}

TEST_F(MapFiles, AFullDiskLeavesNoHalfFileAndKeepsTheOldOne) {
  const Grid map = everyValue();
  const auto frames = someFrames(10, 361);
  auto writers = writersOf(map);
  writers.emplace_back([&](const fs::path& p) { io::writeSimplemap(p, frames); });
  io::writeWhole(folder / "map.x", "old");
  for (const auto& write : writers) {
    std::string error;
    {
      const FullDisk full(500);
      error = errorOf([&] { write(folder / "map.x"); });
    }
    EXPECT_NE(error.find("map.x"), std::string::npos) << error;
    EXPECT_EQ(io::readWhole(folder / "map.x"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  }
}
