#include <gtest/gtest.h>

#include <limits>

#include "ariadne/batch/experiment.h"
#include "ariadne/core/error.h"

using namespace ariadne;
using batch::Experiment;

namespace {

const std::string kBase =
    "[experiment]\ntitle = T\n[arm.a]\nprogram = ariadne-slam\nconfig = a.ini\n"
    "[figures]\nnames = x\n";

/// The message about a text that is wrong.
std::string messageOf(const std::string& text) {
  try {
    batch::parseExperiment(text, "e.ini");
  } catch (const core::UsageError& e) {
    return e.what();
  }
  return "no error";
}

void expectIn(const std::string& part, const std::string& text) {
  const std::string message = messageOf(text);
  EXPECT_NE(message.find(part), std::string::npos) << message << "\nfor\n" << text;
}

}  // namespace

TEST(ExperimentIni, ReadsAll) {
  const Experiment x = batch::parseExperiment(
      "[experiment]\ntitle = Does it help?\n"
      "[arm.with recovery]\nprogram = ariadne-slam\nconfig = a.ini\ndataset = d.rawlog\n"
      "args = --truth t.tum\nprefix = recovered_\nset.filter.particles = 7\nset.a.b = \"x # y\"\n"
      "[factor.laps]\nkey = --laps\nvalues = 1, 3,10\n"
      "[factor.world]\nkey = world.file\nvalues = a.world\n"
      "[seeds]\nfirst = 5\nlast = 60\n"
      "[figures]\nnames = ate_rmse_m, costs.cpu_s\nsuccess = ate_rmse_m <= 0.5 # m\n"
      "[plots]\nfigures = costs.cpu_s\nover = laps\n"
      "[limits]\ntime_s = 1.5\nthreads = 2\nkeep_files = yes\n",
      "folder/e.ini");
  EXPECT_EQ(x.title, "Does it help?");
  ASSERT_EQ(x.arms.size(), 1U);
  EXPECT_EQ(x.arms[0].name, "with recovery");
  EXPECT_EQ(x.arms[0].dataset, "d.rawlog");
  EXPECT_EQ(x.arms[0].prefix, "recovered_");
  EXPECT_EQ(x.arms[0].args, (std::vector<std::string>{"--truth", "t.tum"}));
  ASSERT_EQ(x.arms[0].settings.size(), 2U);
  EXPECT_EQ(x.arms[0].settings[1].key, "a.b");
  EXPECT_EQ(x.arms[0].settings[1].value, "x # y");
  ASSERT_EQ(x.factors.size(), 2U);
  EXPECT_EQ(x.factors[0].values, (std::vector<std::string>{"1", "3", "10"}));
  EXPECT_EQ(x.first_seed, 5U);
  EXPECT_EQ(x.last_seed, 60U);
  EXPECT_EQ(x.figures, (std::vector<std::string>{"ate_rmse_m", "costs.cpu_s"}));
  EXPECT_EQ(x.success.text(), "ate_rmse_m <= 0.5");
  EXPECT_EQ(x.plots.over, "laps");
  EXPECT_TRUE(x.plots.has("costs.cpu_s"));
  EXPECT_FALSE(x.plots.has("success"));
  EXPECT_DOUBLE_EQ(x.limits.time_s, 1.5);
  EXPECT_EQ(x.limits.threads, 2);
  EXPECT_TRUE(x.limits.keep_files);
}

TEST(ExperimentIni, AFactorsValuesMayNameSettings) {
  const Experiment x = batch::parseExperiment(
      kBase + "relative = x\n[factor.noise]\nvalues = as it is, 0.5\nset.0.5.noise.turn = 0.1\n" +
          "set.0.5.noise.side = 0.2\n",
      "e.ini");
  ASSERT_EQ(x.factors.size(), 1U);
  EXPECT_EQ(x.factors[0].values, (std::vector<std::string>{"as it is", "0.5"}));
  ASSERT_EQ(x.factors[0].settings.size(), 1U);
  const auto& half = x.factors[0].settings.at("0.5");
  ASSERT_EQ(half.size(), 2U);
  EXPECT_EQ(half[0].key, "noise.turn");
  EXPECT_EQ(half[1].key, "noise.side");
  EXPECT_EQ(half[1].value, "0.2");
  EXPECT_EQ(x.relative, (std::vector<std::string>{"x"}));
}

TEST(ExperimentIni, ErrorsOfAFactorsSettings) {
  const std::string factor = kBase + "[factor.p]\nvalues = half, all\n";
  expectIn("no error", factor + "set.half.a.b = 1\n");
  expectIn("e.ini:8: [factor.p] set.hlaf.a.b: hlaf is none of its values; the nearest is half",
           factor + "set.hlaf.a.b = 1\n");
  expectIn("e.ini:10: [factor.p] set.half.b", factor + "set.half.b = 1\n");
  expectIn("set.VALUE.SECTION.KEY", factor + "set.half.b = 1\n");
  expectIn("has a key and set.VALUE", factor + "key = a.b\nset.half.a.b = 1\n");
  expectIn("has no key", factor);
  expectIn("has no values", kBase + "[factor.p]\nset.half.a.b = 1\n");
  expectIn("relative = y: takes figures that names has, here x", kBase + "relative = y\n");
}

TEST(ExperimentIni, ErrorsNamePlaceAndRemedy) {
  expectIn("no error", kBase);
  expectIn("title is missing", "[arm.a]\nprogram = x\nconfig = y\n[figures]\nnames = x\n");
  expectIn("e.ini:9: [seeds] frist = 1", kBase + "[seeds]\nfrist = 1\n");
  expectIn("the nearest is \"time_s\"", kBase + "[limits]\ntime = 1\n");
  expectIn("e.ini:8: ", kBase + "[limit]\ntime_s = 1\n");
  expectIn("e.ini:9: [arm.b] setfilter.particles", kBase + "[arm.b]\nsetfilter.particles = 3\n");
  expectIn("set.SECTION.KEY", kBase + "[arm.b]\nset.particles = 3\n");
  expectIn("e.ini:8: [arm.b] has no program", kBase + "[arm.b]\nconfig = a.ini\n");
  expectIn("e.ini:8: [arm.b] has no config", kBase + "[arm.b]\nprogram = ariadne-slam\n");
  expectIn("give it a name behind the dot", kBase + "[arm.]\nconfig = a.ini\n");
  expectIn("as filter.particles", kBase + "[factor.p]\nkey = particles\nvalues = 1\n");
  expectIn("each once", kBase + "[factor.p]\nkey = a.b\nvalues = 1, 2, 1\n");
  expectIn("has no values", kBase + "[factor.p]\nkey = a.b\n");
  expectIn("before first", kBase + "[seeds]\nfirst = 5\nlast = 2\n");
  expectIn("takes a whole number", kBase + "[seeds]\nfirst = one\n");
  expectIn("takes a number", kBase + "[limits]\ntime_s = -1\n");
  expectIn("[figures] is missing", "[experiment]\ntitle = T\n[arm.a]\nprogram = x\nconfig = y\n");
  expectIn("no [arm.NAME]", "[experiment]\ntitle = T\n");
  expectIn("compares with", kBase + "success = a == 3\n");
  expectIn("is no number", kBase + "success = a <= b\n");
  expectIn("takes a figure", kBase + "success = <= 3\n");
  expectIn("no error", kBase + "[plots]\nfigures = x, success\n");
  expectIn("takes all, none, success, x", kBase + "[plots]\nfigures = x, y\n");
  expectIn("there is no [factor.p]", kBase + "[plots]\nover = p\n");
  expectIn("the nearest is \"over\"", kBase + "[plots]\novr = p\n");
}

TEST(ExperimentIni, SuccessByBound) {
  const auto success = [](const std::string& text) {
    return batch::parseSuccess({"figures", "success", text, "e.ini:1"});
  };
  EXPECT_EQ(success("a <= 2").of({{"a", 2}}), batch::Judgement::success);
  EXPECT_EQ(success("a<2").of({{"a", 2}}), batch::Judgement::no_success);
  EXPECT_EQ(success("a >=2").of({{"a", 2}}), batch::Judgement::success);
  EXPECT_EQ(success("a > 2").of({{"a", 2}}), batch::Judgement::no_success);
  EXPECT_EQ(success("a").of({{"a", 1}}), batch::Judgement::success);
  EXPECT_EQ(success("a").of({{"a", 0}}), batch::Judgement::no_success);
  EXPECT_EQ(success("a >= 0").of({{"b", 2}}), batch::Judgement::no_success)
      << "a run without the figure is no success";
  const batch::Figures none = {{"a", std::numeric_limits<double>::quiet_NaN()}};
  for (const char* text : {"a", "a >= 0", "a < 1"})
    EXPECT_EQ(success(text).of(none), batch::Judgement::unjudged) << text;
}
