#include <cmath>
#include <limits>

#include "ariadne/batch/store.h"
#include "ariadne/core/error.h"
#include "stand_in.h"

using namespace ariadne;
namespace fs = std::filesystem;

namespace {

class Storing : public StandIn {
 protected:
  void SetUp() override {
    StandIn::SetUp();
    plan = batch::planOf(batch::readExperiment(ini()));
  }
  std::string refusal() {
    try {
      batch::Store(results()).writePlan(plan);
    } catch (const core::Error& e) {
      return e.what();
    }
    return "no error";
  }
  batch::Plan plan;
};

}  // namespace

TEST_F(Storing, ThePlanReadsBack) {
  const batch::Store store(results());
  store.writePlan(plan);
  const batch::Plan again = store.readPlan();
  EXPECT_EQ(again.title, plan.title);
  ASSERT_EQ(again.runs.size(), plan.runs.size());
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    EXPECT_EQ(again.runs[i].key, plan.runs[i].key);
    EXPECT_EQ(again.runs[i].arguments, plan.runs[i].arguments);
    EXPECT_EQ(batch::describe(again, again.runs[i]), batch::describe(plan, plan.runs[i]));
  }
  EXPECT_EQ(again.files, plan.files);
  EXPECT_EQ(again.ini, io::readWhole(ini()));
  EXPECT_EQ(again.plots.figures, plan.plots.figures);
  for (const auto& [hash, text] : plan.configs) EXPECT_EQ(io::readWhole(store.config(hash)), text);
}

TEST_F(Storing, APlanOfBeforeThereWerePlotsIsRead) {
  const batch::Store store(results());
  store.writePlan(plan);
  std::string text = io::readWhole(results() / "plan.json");
  for (const std::string key : {"\n \"ini\"", "\n \"plots\""})
    text.erase(text.find(key), text.find("\n \"", text.find(key) + 1) - text.find(key));
  io::writeWhole(results() / "plan.json", text);
  EXPECT_EQ(store.readPlan().ini, "");
  EXPECT_TRUE(store.readPlan().plots.has("value"));
}

TEST_F(Storing, NumbersThatARunCannotHaveAreNamed) {
  batch::Store(results()).writePlan(plan);
  const std::string good = io::readWhole(results() / "plan.json");
  for (const auto& [key, value] :
       {std::pair("threads", "99999999999"), {"seed", "-1"}, {"arm", "0.5"}}) {
    std::string text = good;
    const std::size_t at = text.find(':', text.find(std::string("\"") + key + "\"")) + 1;
    text.replace(at, text.find_first_of(",\n", at) - at, value);
    io::writeWhole(results() / "plan.json", text);
    try {
      batch::Store(results()).readPlan();
      FAIL() << key;
    } catch (const core::Error& e) {
      EXPECT_NE(std::string(e.what()).find(std::string(key) + " is " + value), std::string::npos)
          << e.what();
    }
  }
}

TEST_F(Storing, AFolderOfAnotherExperimentIsRefused) {
  batch::Store(results()).writePlan(plan);
  plan.title = "Another";
  EXPECT_NE(refusal().find("holds the results of \"Test\", not of \"Another\""), std::string::npos)
      << refusal();
}

TEST_F(Storing, AFolderOfSomethingElseIsRefused) {
  fs::create_directories(results());
  io::writeWhole(results() / "thesis.tex", std::string_view("x"));
  EXPECT_NE(refusal().find("no plan.json"), std::string::npos) << refusal();
  EXPECT_EQ(io::readWhole(results() / "thesis.tex"), "x");
  fs::remove_all(results());
  io::writeWhole(results(), std::string_view("a file"));
  EXPECT_NE(refusal().find("is no folder"), std::string::npos) << refusal();
  fs::remove_all(results());
  EXPECT_THROW(batch::Store(results()).readPlan(), core::UsageError);
}

TEST_F(Storing, ResultsReadBackAndAFailureDoesNotReplaceASuccess) {
  const batch::Store store(results());
  store.writePlan(plan);
  batch::RunResult r;
  r.key = plan.runs[0].key;
  r.about = "seed 1";
  r.wall_s = 0.1;
  r.figures = {{"a", 1.0 / 3}, {"b", 1}};
  EXPECT_FALSE(store.result(r.key));
  store.put(r);
  EXPECT_EQ(store.result(r.key)->figures, r.figures);
  r.figures["none"] = std::numeric_limits<double>::quiet_NaN();
  store.put(r);
  EXPECT_TRUE(std::isnan(store.result(r.key)->figures.at("none"))) << "there, and no number";
  batch::RunResult failed = r;
  failed.failure = "exit code 1";
  failed.last_words = std::string("no UTF-8: \xff\xfe \"quoted\"\n\x01");
  store.put(failed);
  EXPECT_EQ(store.result(r.key)->failure, "");
  failed.key = plan.runs[1].key;
  store.put(failed);
  EXPECT_EQ(store.result(failed.key)->failure, "exit code 1");
  store.forget(failed.key);
  EXPECT_FALSE(store.has(failed.key));
}

TEST_F(Storing, ADamagedResultIsNamed) {
  const batch::Store store(results());
  store.writePlan(plan);
  io::writeWhole(results() / "runs" / (plan.runs[0].key + ".json"), std::string_view("{\"key\":"));
  try {
    store.results(plan);
    FAIL();
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find(plan.runs[0].key + ".json"), std::string::npos);
  }
}

TEST_F(Storing, OfADeadOwnerOnlyItsOwnIsCleared) {
  const batch::Store store(results());
  store.writePlan(plan);
  const fs::path dead = results() / "runs" / ".k.77-99.part.json";
  const fs::path living =
      results() / "runs" / ".k.77-98.part.json";  // of a later one, or elsewhere
  for (const fs::path& file : {dead, living}) io::writeWhole(file, std::string_view("{"));
  fs::create_directories(store.scratch("elsewhere-77-99"));
  store.clearAfter("elsewhere-77-99");
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(living));
  EXPECT_FALSE(fs::exists(store.scratch("elsewhere-77-99")));
}
