#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "ariadne/batch/plots.h"
#include "ariadne/core/error.h"
#include "ariadne/process/find_program.h"
#include "made_experiment.h"

using namespace ariadne;
using namespace ariadne::batch;

namespace {

std::vector<Plot> plots(const MadeExperiment& m) { return plotsOf(m.plan, m.cells()); }

/// Where a text stands in an SVG, as gnuplot writes it.
std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
  return n;
}

}  // namespace

TEST(PlotData, RatesAndMediansWithIntervals) {
  const auto all = plots(MadeExperiment());
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].name, "success");
  EXPECT_EQ(all[0].figure, "success (%)");
  EXPECT_EQ(all[0].places, (std::vector<std::string>{"one", "two"}));
  EXPECT_TRUE(all[0].numbers.empty());
  ASSERT_EQ(all[0].series[0].points.size(), 1U);
  const PlotPoint& rate = all[0].series[0].points[0];
  EXPECT_DOUBLE_EQ(rate.value, 30);
  // Wilson by hand: z = 1.959964, (p + z^2 / 2n -+ z sqrt(p q / n + z^2 / 4n^2)) / (1 + z^2 / n).
  EXPECT_NEAR(rate.low, 10.7791, 1e-4);
  EXPECT_NEAR(rate.high, 60.3222, 1e-4);
  const PlotPoint& sure = all[0].series[1].points[0];
  EXPECT_EQ(sure.place, 1U);
  EXPECT_DOUBLE_EQ(sure.high, 100);
  EXPECT_NEAR(sure.low, 72.2467, 1e-4);
  EXPECT_EQ(all[1].figure, "x (m)");
  const PlotPoint& median = all[1].series[0].points[0];
  EXPECT_DOUBLE_EQ(median.value, 5.5);
  // All samples summed: 2.0 % of the medians are <= 2.5 and 5.5 % are <= 3, so the exact end is 3;
  // of 1999 samples (standard deviation 0.3 %) it may be the next one. Likewise above, 8.
  EXPECT_GE(median.low, 2.5);
  EXPECT_LE(median.low, 3);
  EXPECT_GE(median.high, 8);
  EXPECT_LE(median.high, 8.5);
  EXPECT_EQ(median.runs, 10U);
}

TEST(PlotData, NumbersMakeAnAxisWordsDoNot) {
  const auto numbers = plots(MadeExperiment({"10", "2", "5.5"}))[0];
  EXPECT_EQ(numbers.numbers, (std::vector<double>{2, 5.5, 10}));
  EXPECT_EQ(numbers.places, (std::vector<std::string>{"2", "5.5", "10"}));
  EXPECT_EQ(numbers.factor, "laps");
  EXPECT_EQ(numbers.series[1].points[2].place, 2U);
  const auto words = plots(MadeExperiment({"10", "many"}))[0];
  EXPECT_TRUE(words.numbers.empty());
  EXPECT_EQ(words.places, (std::vector<std::string>{"10", "many"}));
  EXPECT_TRUE(plots(MadeExperiment({"10"}))[0].numbers.empty()) << "one number is no axis";
}

TEST(PlotData, WhatIsMissingIsLeftOut) {
  MadeExperiment m({"1", "2", "3"});
  m.forget("2", 0);
  const auto all = plots(m);
  ASSERT_EQ(all[0].series[0].points.size(), 2U);
  EXPECT_EQ(all[0].series[0].points[1].place, 2U);
  EXPECT_EQ(all[0].series[1].points.size(), 3U);
  EXPECT_EQ(all[1].series[0].points.size(), 2U);
  m.results.clear();
  EXPECT_TRUE(plots(m).empty());
}

TEST(PlotData, OtherFactorsHavePlotsOfTheirOwn) {
  MadeExperiment m({"small", "large"});
  m.plan.factors.push_back("noise");
  for (PlannedRun& run : m.plan.runs) run.values.emplace_back("2");
  const auto runs = m.plan.runs;
  m.plan.runs.clear();
  for (PlannedRun run : runs) {
    m.plan.runs.push_back(run);
    run.values[1] = "4";
    m.plan.runs.push_back(run);
  }
  // Seeds must come arm by arm: all of a seed's combinations before the next.
  std::stable_sort(m.plan.runs.begin(), m.plan.runs.end(),
                   [](const auto& a, const auto& b) { return a.seed < b.seed; });
  const auto over_noise = plots(m);
  ASSERT_EQ(over_noise.size(), 4U);
  EXPECT_EQ(over_noise[0].factor, "noise") << "the first factor of numbers";
  EXPECT_EQ(over_noise[0].panel, "laps small");
  EXPECT_EQ(over_noise[1].name, "success_large");
  m.plan.plots.over = "laps";
  EXPECT_EQ(plots(m)[1].panel, "noise 4");
  m.plan.plots.figures = {"x_m"};
  EXPECT_EQ(plots(m).size(), 2U);
  m.plan.plots.figures = {"none"};
  EXPECT_TRUE(plots(m).empty());
}

TEST(PlotData, NamesFitForFilesAndDiffer) {
  MadeExperiment m({"a/b", "a b"});
  m.plan.factors = {"laps"};
  m.plan.figures = {"../x", ".._x"};
  for (auto& [key, r] : m.results) r.figures = {{"right", 1}, {"../x", 1}, {".._x", 2}};
  const auto all = plots(m);
  EXPECT_EQ(all[1].name, "___x");
  EXPECT_EQ(all[2].name, "___x_2");
}

TEST(PlotData, UnitsFromNames) {
  EXPECT_EQ(withUnit("ate_rmse_m"), "ate_rmse (m)");
  EXPECT_EQ(withUnit("costs.cpu_s"), "costs.cpu (s)");
  EXPECT_EQ(withUnit("turn_deg"), "turn (deg)");
  EXPECT_EQ(withUnit("costs.peak_memory_mb"), "costs.peak_memory (MB)");
  EXPECT_EQ(withUnit("laps"), "laps");
  EXPECT_EQ(withUnit("_m"), "_m");
}

class DrawnPlots : public ::testing::Test {
 protected:
  void SetUp() override {
    if (ariadne::process::findInPath("gnuplot").empty())
      GTEST_SKIP() << "gnuplot-nox is not installed";
  }
};

TEST_F(DrawnPlots, TheSameBytesTwice) {
  const auto data = plots(MadeExperiment({"1", "2", "3"}));
  const auto a = drawPlots(data);
  const auto b = drawPlots(data);
  ASSERT_EQ(a.size(), 2U);
  EXPECT_EQ(a[0].svg, b[0].svg);
  EXPECT_EQ(a[1].svg, b[1].svg);
  EXPECT_EQ(a[0].png.substr(1, 3), "PNG");
  EXPECT_NE(a[0].svg.find("<text>success (%)</text>"), std::string::npos);
  EXPECT_NE(a[0].svg.find("<text>laps</text>"), std::string::npos);
}

TEST_F(DrawnPlots, NamesMeanNothingToGnuplot) {
  const std::string nasty = "a<b>_x^2 {/Bold y} 'q' `date` @m %d";
  for (const char* other : {"1", "word"}) {
    MadeExperiment m({"2", std::string(other) == "1" ? "1" : nasty});
    m.plan.arms[1].name = nasty;
    m.plan.factors = {nasty};
    const auto svg = drawPlots(plots(m))[0].svg;
    const std::string drawn = "<text>a&lt;b>_x^2 {/Bold y} 'q' `date` @m %d</text>";
    EXPECT_EQ(count(svg, drawn), std::string(other) == "1" ? 2U : 3U) << svg;
  }
}

TEST_F(DrawnPlots, APointWithoutSpreadAndAGapAreDrawn) {
  MadeExperiment m({"1", "2", "3"});
  for (auto& [key, r] : m.results) r.figures["x_m"] = 7;
  m.forget("2", 0);
  EXPECT_EQ(drawPlots(plots(m)).size(), 2U);
}

TEST(Gnuplot, MissingIsSaidWithItsPackage) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  try {
    drawPlots(plots(MadeExperiment()));
    ADD_FAILURE();
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find("install gnuplot-nox"), std::string::npos) << e.what();
  }
  ::setenv("PATH", path.c_str(), 1);
}
