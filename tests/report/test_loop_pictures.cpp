#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <unistd.h>

#include <filesystem>

#include "ariadne/core/error.h"
#include "ariadne/report/curves.h"
#include "ariadne/report/topology.h"

namespace fs = std::filesystem;
using namespace ariadne;

namespace {

const fs::path kFile =
    fs::temp_directory_path() / ("ariadne-loops-" + std::to_string(::getpid()) + ".png");

/// Pixels of about this colour, shares of red, green and blue.
std::size_t pixelsOf(const fs::path& file, double r, double g, double b) {
  const auto image = mrpt::img::CImage::LoadFromFile(file.string());
  std::size_t n = 0;
  for (unsigned y = 0; y < image.getHeight(); ++y)
    for (unsigned x = 0; x < image.getWidth(); ++x) {
      const auto close = [&](int channel, double share) {
        return std::abs(*image(x, y, channel) - 255 * share) < 4;
      };
      n += close(2, r) && close(1, g) && close(0, b);
    }
  fs::remove(file);
  return n;
}

mrpt::maps::COccupancyGridMap2D room() {
  mrpt::maps::COccupancyGridMap2D map(0, 10, 0, 8, 0.1f);
  map.fill(0.9f);
  return map;
}

}  // namespace

TEST(TopologyPicture, ShowsWaysShortcutsAndEntries) {
  report::DrawnGraph g;
  g.places = {{1, 1}, {8, 1}, {8, 6}, {1, 6}};
  g.edges = {{0, 1}, {1, 2}, {2, 3}};
  report::writeTopology(kFile, room(), g);
  const auto red = pixelsOf(kFile, 0.75, 0.1, 0.1);
  report::writeTopology(kFile, room(), g);
  const auto legend = pixelsOf(kFile, 0.1, 0.3, 0.85);
  g.shortcuts = {{3, 0}};
  g.entries = {{{1, 1}, 0}};
  report::writeTopology(kFile, room(), g);
  EXPECT_GT(red, 1000U);
  EXPECT_GT(pixelsOf(kFile, 0.1, 0.3, 0.85), legend + 500) << "5 m of blue line";
}

TEST(TopologyPicture, EntriesAtOneSpotStandSideBySide) {
  report::DrawnGraph g;
  g.places = {{5, 4}};
  g.entries = {{{5, 4}, 0}};
  report::writeTopology(kFile, room(), g);
  const auto one = pixelsOf(kFile, 0.1, 0.3, 0.85);
  g.entries = {{{5, 4}, 0}, {{5, 4}, 3}, {{5.02, 4}, 12}};
  report::writeTopology(kFile, room(), g);
  EXPECT_GT(pixelsOf(kFile, 0.1, 0.3, 0.85), one + 250) << "two more discs of over 150 pixels";
}

TEST(TopologyPicture, ErrorsNameTheFileAndLeaveNothing) {
  EXPECT_THROW(report::writeTopology("/nowhere/at/all.png", room(), {}), core::Error);
  mrpt::maps::COccupancyGridMap2D nothing;
  nothing.setSize(0, 0.02f, 0, 0.02f, 0.1f);
  try {
    report::writeTopology(kFile, nothing, {});
    ADD_FAILURE() << "no core::Error";
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find(kFile.string()), std::string::npos) << e.what();
  }
  EXPECT_FALSE(fs::exists(kFile));
}

TEST(CurvesPicture, ShowsEachCurve) {
  report::CurveChart chart{"t", "x", "y", {{"a", {0, 5, 10}, {1, 9, 3}}}, {{"here", 5}}};
  report::writeCurves(kFile, chart);
  EXPECT_GT(pixelsOf(kFile, 0, 0.45, 0.70), 500U);
  chart.curves[0].y.pop_back();
  EXPECT_THROW(report::writeCurves(kFile, chart), core::Error);
  chart.curves.clear();
  report::writeCurves(kFile, chart);
  EXPECT_TRUE(fs::exists(kFile));
  EXPECT_THROW(report::writeCurves("/nowhere/at/all.png", chart), core::Error);
  fs::remove(kFile);
}

TEST(CurvesPicture, BandsLieUnderTheCurves) {
  report::CurveChart chart{"t", "x", "y", {{"a", {0, 10}, {5, 5}}}, {}};
  const auto pixels = [&](double r, double g, double b) {
    report::writeCurves(kFile, chart);
    return static_cast<double>(pixelsOf(kFile, r, g, b));
  };
  const double line = pixels(0, 0.45, 0.70);
  const double grey = pixels(0.5, 0.5, 0.5);
  chart.bands = {{2, 7, 0.5}};
  // Half of a plot of 830 x 420 pixels or more, less grid and curve.
  EXPECT_GT(pixels(0.5, 0.5, 0.5), grey + 0.45 * 830 * 420);
  // Two rows of the line are mixed with what lies under it.
  EXPECT_GT(pixels(0, 0.45, 0.70), 0.9 * line);
}

TEST(CurvesPicture, ALegendOfAnyLengthHasRoom) {
  report::CurveChart chart{"t", "x", "y", {}, {}};
  for (int i = 0; i < 7; ++i)
    chart.curves.push_back({"a name that takes its room " + std::to_string(i), {0, 1}, {0, 1}});
  chart.curves.back().colour = 5;  // nobody else's but that of the sixth
  report::writeCurves(kFile, chart);
  EXPECT_EQ(mrpt::img::CImage::LoadFromFile(kFile.string()).getHeight(), 560U + 2 * 20);
  const auto whole = pixelsOf(kFile, 0.90, 0.62, 0.0);
  chart.curves.back().dashed = true;
  chart.curves[5].dashed = true;
  report::writeCurves(kFile, chart);
  EXPECT_LT(pixelsOf(kFile, 0.90, 0.62, 0.0), whole * 4 / 5);
}

TEST(CurvesPicture, NamesOfMomentsAtTheEndsStayInTheFrame) {
  report::CurveChart chart{"t", "x", "y", {{"a", {0, 10}, {1, 9}}}, {}};
  const auto dark = [&] {
    report::writeCurves(kFile, chart);
    const auto image = mrpt::img::CImage::LoadFromFile(kFile.string());
    std::size_t n = 0;
    for (unsigned y = 0; y < 480; ++y)
      for (unsigned x = 972; x < 1000; ++x) n += *image(x, y, 1) < 200;
    fs::remove(kFile);
    return n;
  };
  const auto without = dark();
  chart.moments = {{"recovery 12", 0}, {"recovery 13", 10}};
  EXPECT_LE(dark(), without + 2) << "text right of the frame";
}
