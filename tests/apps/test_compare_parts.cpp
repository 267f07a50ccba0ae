#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ariadne/core/error.h"
#include "comparison_output.h"
#include "forecast.h"

using namespace ariadne;
using namespace ariadne::compare_app;

namespace {

Comparison example() {
  Comparison c;
  c.settings = "Some.";
  c.figures = {{{"cpu", "s", "time"}, {1, 3, 2}, {20, 10, 40}},
               {{"updates", "", "of the filter"}, {7, 7, 7}, {0, 0, 0}}};
  return c;
}

}  // namespace

TEST(Comparison, MediansRangesAndTheirRatio) {
  const Comparison c = example();
  EXPECT_EQ(valueOf(c, "ours_cpu_s"), 2);
  EXPECT_EQ(valueOf(c, "stock_cpu_s"), 20);
  EXPECT_EQ(valueOf(c, "cpu_ratio"), 0.1);
  EXPECT_EQ(valueOf(c, "ours_updates"), 7);
  EXPECT_TRUE(std::isnan(valueOf(c, "updates_ratio")));
  EXPECT_EQ(spreadOf({4, 1, 2, 3}).median, 2.5);
  EXPECT_EQ(spreadText({2, 1, 4}), "2 (1 to 4)");
  EXPECT_EQ(spreadText({7, 7}), "7");
}

TEST(Comparison, IsWrittenWithItsRequirements) {
  const Comparison c = example();
  std::vector<FigureKind> kinds;
  for (const auto& f : c.figures) kinds.push_back(f.kind);
  const auto names = valueNames(kinds);
  const std::vector<Requirement> both{parseRequirement("cpu_ratio<=0.1", names, names),
                                      parseRequirement(" updates_ratio < 1e9 ", names, names)};
  EXPECT_TRUE(both[0].metBy(0.1));
  EXPECT_FALSE(both[1].metBy(std::numeric_limits<double>::quiet_NaN()));
  const std::string text = comparisonText(c, both);
  EXPECT_NE(text.find("met: cpu_ratio<=0.1 (it is 0.1)"), std::string::npos) << text;
  EXPECT_NE(text.find("NOT MET:  updates_ratio < 1e9"), std::string::npos) << text;
  const auto json = comparisonJson(c, both);
  EXPECT_TRUE(json["figures"]["updates"]["ratio"].is_null());
  EXPECT_EQ(json["figures"]["cpu_s"]["stock"]["max"], 40);
}

TEST(Forecast, IsOfBeginningsThenOfTheRunThenOfRunsThatEnded) {
  Forecast forecast(3);
  EXPECT_EQ(forecast.text(), "");
  forecast.expect(Side::ours, 4);
  EXPECT_FALSE(forecast.left_s({Side::ours, 1, 0})) << "nothing is known of stock";
  forecast.expect(Side::stock, 60);
  EXPECT_EQ(forecast.text(),
            "3 runs of ariadne-slam, 0:04 each; 3 runs of stock MRPT, 1:00 each; 3:12 in all, as "
            "their beginnings show");
  EXPECT_EQ(forecast.left_s({Side::ours, 1, 0}), 3 + 2 * 4 + 3 * 60);
  forecast.ended(Side::ours, 6);
  // Half of the updates in 50 s: 100 s a run now, where the beginning said 60.
  EXPECT_EQ(forecast.left_s({Side::stock, 50, 0.5}), 50 + 2 * 6 + 2 * 60);
  EXPECT_EQ(forecast.left_s({Side::stock, 70, 0.01}), 0 + 2 * 6 + 2 * 60) << "too early to tell";
  forecast.ended(Side::stock, 100);
  EXPECT_EQ(forecast.progressText({Side::ours, 1, 0}),
            "run 2 of 3, ariadne-slam: 34 % of all, 3:31 left");
  EXPECT_EQ(forecast.left_s({Side::ours, 1, 0}), 5 + 6 + 2 * 100);
}

TEST(Requirement, OfAnyLengthIsAnsweredAndNotAnOverflow) {
  for (const std::string& text : {std::string(200000, 'a'), "a<" + std::string(200000, '1')})
    EXPECT_THROW(parseRequirement(text, {"a"}, {}), core::UsageError);
}
