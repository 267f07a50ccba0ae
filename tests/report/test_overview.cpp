#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <unistd.h>

#include "ariadne/core/error.h"
#include "ariadne/report/overview.h"

namespace fs = std::filesystem;
using ariadne::models::Trajectory;
using ariadne::report::writeOverview;
using Grid = mrpt::maps::COccupancyGridMap2D;

namespace {

fs::path pictureFile() {
  return fs::temp_directory_path() / ("ariadne-overview-" + std::to_string(::getpid()) + ".png");
}

mrpt::img::CImage drawn(const Grid& map, const Trajectory& path) {
  const fs::path file = pictureFile();
  writeOverview(file, map, path);
  auto image = mrpt::img::CImage::LoadFromFile(file.string());
  fs::remove(file);
  return image;
}

}  // namespace

TEST(Overview, ShowsMapAndPathInTheirPlaces) {
  Grid map(0, 12, 0, 6, 0.1f);
  for (unsigned y = 0; y < map.getSizeY(); ++y)
    for (unsigned x = 0; x < map.getSizeX(); ++x)
      map.getRow(static_cast<int>(y))[x] = x < 60 ? 127 : -127;
  // 100 pixels a metre, margin 20: the path runs along y = 3 from x = 1 to x = 5.
  const auto image = drawn(map, {{0, {1, 3, 0}}, {10, {5, 3, 0}}});
  EXPECT_EQ(image.getWidth(), 1240U);
  EXPECT_GT(image.getAsFloat(300, 100), 0.95);  // free
  EXPECT_LT(image.getAsFloat(1000, 100), 0.1);  // occupied
  const auto* start = image(120, 320);          // blue, green, red
  EXPECT_GT(start[0], 150);
  EXPECT_LT(start[2], 80);
  const auto* end = image(520, 320);
  EXPECT_GT(end[2], 150);
  EXPECT_LT(end[0], 80);
}

TEST(Overview, NothingKnownAndNoPathIsStillAPicture) {
  EXPECT_GT(drawn(Grid(0, 1, 0, 1, 0.1f), {}).getWidth(), 500U);
  EXPECT_GT(drawn(Grid(0, 0.1f, 0, 0.1f, 0.1f), {{0, {0, 0, 0}}}).getWidth(), 500U);
}

TEST(Overview, APathThatCannotBeWrittenIsNamed) {
  try {
    writeOverview("/nowhere/overview.png", Grid(0, 1, 0, 1, 0.1f), {});
    FAIL();
  } catch (const ariadne::core::Error& e) {
    EXPECT_NE(std::string(e.what()).find("/nowhere/overview.png"), std::string::npos) << e.what();
  }
}
