#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <unistd.h>

#include <functional>
#include <string>

#include "ariadne/core/error.h"
#include "ariadne/report/overview.h"

namespace fs = std::filesystem;
using ariadne::geometry::Trajectory;
using ariadne::report::writeOverview;
using Grid = mrpt::maps::COccupancyGridMap2D;

namespace {

constexpr int kMargin = 20;

class Overview : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  mrpt::img::CImage drawn(const Grid& map, const Trajectory& path) const {
    writeOverview(folder / "overview.png", map, path);
    return mrpt::img::CImage::LoadFromFile((folder / "overview.png").string());
  }

  const fs::path folder =
      fs::temp_directory_path() / ("ariadne-overview-" + std::to_string(::getpid()));
};

/// Unknown but for a free rectangle of cells.
Grid withRoom(int cells_x, int cells_y, int x0, int y0, int x1, int y1) {
  Grid map(0, static_cast<float>(cells_x) * 0.1f, 0, static_cast<float>(cells_y) * 0.1f, 0.1f);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) map.getRow(y)[x] = 127;
  return map;
}

bool isBlue(const std::uint8_t* bgr) { return bgr[0] > 150 && bgr[1] < 80 && bgr[2] < 80; }
bool isRed(const std::uint8_t* bgr) { return bgr[2] > 150 && bgr[1] < 80 && bgr[0] < 80; }

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

TEST_F(Overview, ShowsMapAndPathInTheirPlaces) {
  Grid map = withRoom(120, 60, 0, 0, 60, 60);
  for (int y = 0; y < 60; ++y)
    for (int x = 60; x < 120; ++x) map.getRow(y)[x] = -128;
  map.getRow(59)[0] = 0;  // north west
  // 100 pixels a metre, margin 20: the path runs along y = 3 from x = 1 to x = 5.
  const auto image = drawn(map, {{0, {1, 3, 0}}, {10, {5, 3, 0}}});
  EXPECT_EQ(image.getWidth(), 1240U);
  EXPECT_GT(image.getAsFloat(300, 100), 0.95);             // free
  EXPECT_LT(image.getAsFloat(1000, 100), 0.1);             // occupied
  EXPECT_NEAR(image.getAsFloat(25, 25), 205 / 255., .01);  // unknown
  EXPECT_TRUE(isBlue(image(120, 320)));
  EXPECT_TRUE(isRed(image(520, 320)));
  EXPECT_LT(image.getAsFloat(320, 320), 0.8) << "no line between start and end";
}

TEST_F(Overview, APauseInTheLogDoesNotUseUpTheColours) {
  // Along y = 3 from x = 1 to x = 5; hours pass before the last pose.
  Trajectory path;
  for (int i = 0; i <= 40; ++i) path.push_back({i < 40 ? i * 0.1 : 10000, {1 + i * 0.1, 3, 0}});
  const auto image = drawn(withRoom(120, 60, 0, 0, 120, 60), path);
  EXPECT_TRUE(isBlue(image(140, 320)));
  const auto* middle = image(320, 320);
  EXPECT_GT(middle[1], middle[0]) << "not green";
  EXPECT_GT(middle[1], middle[2]) << "not green";
  EXPECT_TRUE(isRed(image(500, 320)));
}

TEST_F(Overview, OnlyTheKnownPartIsShown) {
  // 240 x 120 cells are known: 5 pixels per cell.
  const auto image = drawn(withRoom(1000, 1000, 300, 500, 540, 620), {});
  EXPECT_EQ(image.getWidth(), 240U * 5 + 2 * kMargin);
  EXPECT_GT(image.getAsFloat(kMargin, kMargin), 0.95);
  EXPECT_GT(image.getAsFloat(kMargin + 1199, kMargin + 599), 0.95);
  EXPECT_LT(image.getAsFloat(kMargin - 1, kMargin), 0.85);
  EXPECT_LT(image.getAsFloat(kMargin + 1200, kMargin + 599), 0.85);
}

TEST_F(Overview, ThinWallsOfALargeMapStay) {
  Grid map = withRoom(3000, 2000, 0, 0, 3000, 2000);
  for (int x = 0; x < 3000; ++x) map.getRow(1000)[x] = -127;
  // Three cells a pixel from the south: row 1000 is in the 334th of 667 rows.
  const auto image = drawn(map, {});
  EXPECT_EQ(image.getWidth(), 1000U + 2 * kMargin);
  for (int x = 0; x < 1000; ++x)
    ASSERT_LT(image.getAsFloat(kMargin + x, kMargin + 667 - 334), 0.1) << x;
}

TEST_F(Overview, NothingKnownNoPathAndOneCellAreStillPictures) {
  const Grid one(0, 0.1f, 0, 0.1f, 0.1f);
  EXPECT_GT(drawn(Grid(0, 1, 0, 1, 0.1f), {}).getWidth(), 500U);
  EXPECT_GT(drawn(one, {}).getWidth(), 500U);
  EXPECT_GT(drawn(one, {{0, {0, 0, 0}}}).getWidth(), 500U);
  EXPECT_GT(drawn(one, {{0, {0, 0, 0}}, {0, {50, 0, 0}}}).getWidth(), 500U);
}

TEST_F(Overview, AMapWithoutCellsIsRefusedByName) {
  Grid map;
  map.setSize(0, 0.02f, 0, 0.02f, 0.1f);
  const std::string error = errorOf([&] { writeOverview(folder / "overview.png", map, {}); });
  EXPECT_NE(error.find("overview.png: the map has no cells"), std::string::npos) << error;
}

TEST_F(Overview, APathThatCannotBeWrittenIsNamed) {
  const Grid map(0, 1, 0, 1, 0.1f);
  drawn(map, {});
  const fs::path under_a_file = folder / "overview.png" / "overview.png";
  for (const fs::path& path : {fs::path("/nowhere/overview.png"), under_a_file}) {
    const std::string error = errorOf([&] { writeOverview(path, map, {}); });
    EXPECT_NE(error.find(path.string()), std::string::npos) << error;
  }
}
