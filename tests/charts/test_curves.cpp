#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "../pixels_of.h"
#include "ariadne/charts/curves.h"
#include "ariadne/charts/gnuplot.h"
#include "ariadne/core/error.h"

namespace fs = std::filesystem;
using namespace ariadne;
using test::pixelsOf;

namespace {

const fs::path kFile =
    fs::temp_directory_path() / ("ariadne-curves-" + std::to_string(::getpid()) + ".png");

}  // namespace

TEST(Curves, ShowsEachCurve) {
  charts::CurveChart chart{"t", "x", "y", {{"a", {0, 5, 10}, {1, 9, 3}}}, {{"here", 5}}};
  charts::writeCurves(kFile, chart);
  EXPECT_GT(pixelsOf(kFile, 0, 0.45, 0.70), 500U);
  chart.curves[0].y.pop_back();
  EXPECT_THROW(charts::writeCurves(kFile, chart), core::Error);
  chart.curves.clear();
  charts::writeCurves(kFile, chart);
  EXPECT_TRUE(fs::exists(kFile));
  EXPECT_THROW(charts::writeCurves("/nowhere/at/all.png", chart), core::Error);
  fs::remove(kFile);
}

TEST(Curves, BandsLieUnderTheCurves) {
  charts::CurveChart chart{"t", "x", "y", {{"a", {0, 10}, {5, 5}}}, {}};
  const auto pixels = [&](double r, double g, double b) {
    charts::writeCurves(kFile, chart);
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

TEST(Curves, ALegendOfAnyLengthHasRoom) {
  charts::CurveChart chart{"t", "x", "y", {}, {}};
  for (int i = 0; i < 7; ++i)
    chart.curves.push_back({"a name that takes its room " + std::to_string(i), {0, 1}, {0, 1}});
  chart.curves.back().colour = 4;  // nobody else's but that of the fifth
  charts::writeCurves(kFile, chart);
  EXPECT_EQ(mrpt::img::CImage::LoadFromFile(kFile.string()).getHeight(), 560U + 2 * 20);
  const auto whole = pixelsOf(kFile, 0.90, 0.62, 0.0);
  chart.curves.back().dashed = true;
  chart.curves[4].dashed = true;
  charts::writeCurves(kFile, chart);
  EXPECT_LT(pixelsOf(kFile, 0.90, 0.62, 0.0), whole * 4 / 5);
}

TEST(Curves, NamesOfMomentsAtTheEndsStayInTheFrame) {
  charts::CurveChart chart{"t", "x", "y", {{"a", {0, 10}, {1, 9}}}, {}};
  const auto dark = [&] {
    charts::writeCurves(kFile, chart);
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
