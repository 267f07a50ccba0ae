#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ariadne/batch/figures.h"
#include "ariadne/batch/runs_csv.h"
#include "ariadne/batch/tables.h"
#include "ariadne/core/error.h"
#include "ariadne/statistics/exact_tests.h"

using namespace ariadne;
using namespace ariadne::batch;

namespace {

struct Made {
  Plan plan;
  std::map<std::string, RunResult> results;
};

/// Two arms, ten seeds: the first is right on seeds 1 to 3, the second on 2 to 10; figure x is the
/// seed, of the second arm ten times that. Its run on seed 10 crashed.
Made make(const std::string& factor) {
  Made m;
  m.plan.title = "T";
  m.plan.factors = {factor};
  m.plan.arms = {{"one", "", {}, ""}, {"two_b", "b_", {}, ""}};
  m.plan.figures = {"x"};
  m.plan.success = {"right", "!=", 0};
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const std::string key = std::to_string(seed) + (arm == 0 ? "a" : "b");
      m.plan.runs.push_back({seed, {"7"}, arm, key, "", {}});
      RunResult r;
      r.key = key;
      const double s = static_cast<double>(seed);
      if (arm == 0)
        r.figures = {{"right", seed <= 3}, {"x", s}};
      else if (seed == 10)
        r.failure = "exit code 1";
      else
        r.figures = {{"b_right", seed >= 2}, {"b_x", 10 * s}};
      m.results[key] = r;
    }
  return m;
}

std::string tableText(const Made& m, TableFormat format) {
  return render(tableOf(m.plan, cellsOf(m.plan, m.results), format), format);
}

}  // namespace

TEST(BatchTables, CountsMediansAndPairs) {
  const Made m = make("laps");
  const auto cells = cellsOf(m.plan, m.results);
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].finished, 10U);
  EXPECT_EQ(cells[0].successes, 3U);
  EXPECT_DOUBLE_EQ(*cells[0].medians[0], 5.5);
  EXPECT_FALSE(cells[0].pairs);
  EXPECT_EQ(cells[1].finished, 9U);
  EXPECT_EQ(cells[1].failed, 1U);
  EXPECT_EQ(cells[1].successes, 8U);
  EXPECT_DOUBLE_EQ(*cells[1].medians[0], 50);
  // Only the first: seed 1. Only the second: seeds 4 to 9. Seed 10 has no pair.
  EXPECT_EQ(cells[1].pairs->only_first, 1U);
  EXPECT_EQ(cells[1].pairs->only_this, 6U);
  EXPECT_DOUBLE_EQ(cells[1].pairs->p, statistics::mcnemarTest(1, 6));
}

TEST(BatchTables, InFourFormats) {
  const Made m = make("a_factor|x");
  EXPECT_EQ(
      tableText(m, TableFormat::csv),
      "a_factor|x,arm,runs,failed,successes,rate,rate_low,rate_high,x,x_low,x_high,only_first,"
      "only_this,p,p_holm\n"
      "7,one,10,0,3,0.300000,0.107791,0.603222,5.5,3,8,,,,\n"
      "7,two_b,9,1,8,0.888889,0.565000,0.980109,50,20,80,1,6,0.125,0.125\n");
  const std::string text = tableText(m, TableFormat::text);
  EXPECT_NE(text.find("7           two_b  9     1       8/9 (89 %)   57-98 %"), std::string::npos)
      << text;
  const std::string markdown = tableText(m, TableFormat::markdown);
  EXPECT_NE(markdown.find("| a_factor\\|x | arm |"), std::string::npos) << markdown;
  const std::string latex = tableText(m, TableFormat::latex);
  EXPECT_NE(latex.find("7 & two\\_b & 9 & 1 & 8/9 (89 \\%)"), std::string::npos) << latex;
}

TEST(BatchTables, ChangesAreOfPairs) {
  Made m = make("laps");
  m.plan.relative = {"x"};
  m.results["4b"].figures["b_x"] = 2;  // 50 % less than the first arm's 4; the others 900 % more
  const auto cells = cellsOf(m.plan, m.results);
  EXPECT_TRUE(cells[0].changes[0].empty()) << "the first arm is not compared with itself";
  EXPECT_EQ(cells[1].changes[0],
            (std::vector<double>{900, 900, 900, -50, 900, 900, 900, 900, 900}));
  const std::string text = tableText(m, TableFormat::text);
  EXPECT_NE(text.find("x against one, %"), std::string::npos) << text;
  EXPECT_NE(text.find("+900.0 [+900.0, +900.0]"), std::string::npos) << text;
  EXPECT_NE(tableText(m, TableFormat::csv).find(",x_change_percent,"), std::string::npos);
}

TEST(BatchTables, RunsAsCsvHaveNoTimesHostsOrPaths) {
  Made m = make("laps");
  m.results["2a"].host = "here";
  m.results["2a"].wall_s = 7.25;
  m.results["2a"].figures["x"] = 0.1;
  m.results.erase("1b");
  const std::string csv = runsCsv(m.plan, m.results);
  EXPECT_EQ(csv.substr(0, csv.find("\n3,")),
            "seed,laps,arm,failed,success,x\n1,7,one,0,1,1\n2,7,one,0,1,0.1\n2,7,two_b,0,1,20");
  EXPECT_NE(csv.find("\n10,7,two_b,1,,\n"), std::string::npos) << "it crashed: " << csv;
}

TEST(BatchTables, AnUnjudgedRunIsToldApartAndInNoRate) {
  Made m = make("laps");
  const double none = std::numeric_limits<double>::quiet_NaN();
  m.results["2a"].figures = {{"right", none}, {"x", none}};
  m.results["9b"].figures["b_right"] = none;
  const auto cells = cellsOf(m.plan, m.results);
  EXPECT_EQ(cells[0].finished, 10U);
  EXPECT_EQ(cells[0].unjudged, 1U);
  EXPECT_EQ(cells[0].successes, 2U);
  EXPECT_DOUBLE_EQ(*cells[0].medians[0], 6) << "of 1, 3, 4, ... 10";
  // Only the second: seeds 4 to 8; 9 has no pair, and neither has 2.
  EXPECT_EQ(cells[1].pairs->only_first, 1U);
  EXPECT_EQ(cells[1].pairs->only_this, 5U);
  const std::string text = tableText(m, TableFormat::text);
  EXPECT_NE(text.find("2/9 (22 %)"), std::string::npos) << text;
  EXPECT_NE(text.find("nothing to judge right by"), std::string::npos) << text;
  const std::string csv = tableText(m, TableFormat::csv);
  EXPECT_EQ(csv.rfind("laps,arm,runs,failed,unjudged,successes,rate,", 0), 0U) << csv;
  EXPECT_NE(csv.find("7,one,10,0,1,2,0.222222,"), std::string::npos) << csv;
  EXPECT_NE(runsCsv(m.plan, m.results).find("\n2,7,one,0,unjudged,\n"), std::string::npos);
}

TEST(BatchTables, WithoutResultsItIsEmptyNotWrong) {
  Made m = make("laps");
  m.results.clear();
  const std::string text = tableText(m, TableFormat::csv);
  EXPECT_NE(text.find("7,one,0,0,0,,0.000000,1.000000,,,,,,,\n"), std::string::npos) << text;
}

TEST(BatchTables, AFigureThatNoRunHasIsNamed) {
  Made m = make("laps");
  m.plan.figures = {"xx"};  // the second arm calls its own b_x
  try {
    cellsOf(m.plan, m.results);
    FAIL();
  } catch (const core::UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("the nearest is x of right, x"), std::string::npos)
        << e.what();
  }
}

TEST(BatchFigures, OfSummariesRowsAndPrints) {
  Figures figures = figuresOfSummary(R"({"a": {"b": 1.5, "c": null}, "d": true, "e": "text",
                                         "f": [1], "parameters": {"x": 3}})",
                                     "s");
  EXPECT_TRUE(std::isnan(figures.at("a.c"))) << "the program says that there is none";
  figures.erase("a.c");
  EXPECT_EQ(figures, (Figures{{"a.b", 1.5}, {"d", 1}}));
  EXPECT_THROW(figuresOfSummary("{", "s"), core::Error);
}
