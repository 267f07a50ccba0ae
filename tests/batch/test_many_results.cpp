// What the issue asks of the runner with many runs: its own cost, and the time to aggregate.
#include <ctime>
#include <fstream>

#include "ariadne/batch/experiment_page.h"
#include "ariadne/batch/schedule.h"
#include "ariadne/batch/store.h"
#include "made_experiment.h"
#include "stand_in.h"

using namespace ariadne;

namespace {

class ManyResults : public StandIn {};

}  // namespace

// Read, aggregate and render: 0.7 s of CPU on the machine of doc/reference/experiments.md, 10 s are
// asked for.
TEST_F(ManyResults, TenThousandAreAggregatedInTenSeconds) {
  const MadeExperiment some({"0", "1", "3", "10", "30"});
  batch::Plan plan = some.plan;
  plan.runs.clear();
  std::filesystem::create_directories(results() / "runs");
  for (std::uint64_t seed = 1; seed <= 1000; ++seed)
    for (std::size_t i = 0; i < 10; ++i) {
      batch::PlannedRun run = some.plan.runs[i];
      run.seed = seed;
      run.key += "-" + std::to_string(seed);
      plan.runs.push_back(run);
      batch::RunResult result = some.results.at(some.plan.runs[i].key);
      result.key = run.key;
      result.figures["x_m"] = static_cast<double>(seed * seed % 1009);
      // As summary.json of ariadne-explore: about fifty figures.
      for (int f = 0; f < 50; ++f) result.figures["figure_" + std::to_string(f)] = f / 3.0;
      std::ofstream(results() / "runs" / (run.key + ".json")) << batch::resultText(result);
    }
  const std::clock_t start = std::clock();  // of CPU: a busy machine is not what is tested
  const batch::Store store(results());
  const auto cells = batch::cellsOf(plan, store.results(plan));
  const std::string table = batch::render(batch::tableOf(plan, cells, batch::TableFormat::text),
                                          batch::TableFormat::text);
  const double took_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  RecordProperty("milliseconds", static_cast<int>(1000 * took_s));
  ASSERT_EQ(cells.size(), 10U);
  EXPECT_EQ(cells[9].finished, 1000U);
  EXPECT_NE(table.find("1000/1000"), std::string::npos) << table;
  EXPECT_LT(took_s, 10);
}

// The shortest runs of ini/paper take 0.4 s of CPU (ini/paper/small.ini): 4 ms per run are 1 % of
// those. Measured 0.5 ms; the bound holds under the sanitizers, too.
TEST_F(ManyResults, ARunCostsTheRunnerUnderAHundredthOfTheShortest) {
  writeExperiment("[seeds]\nlast = 100\n");
  const batch::Plan plan = batch::planOf(batch::readExperiment(ini()));
  const batch::Store store(results());
  store.writePlan(plan);
  batch::ScheduleOptions options;
  options.jobs = 2;
  const double before_s = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  const batch::ScheduleEnd end = batch::doRuns(store, plan, options);
  ASSERT_EQ(end.done, 200U);
  const double each_s = (end.own_cpu_s - before_s) / 200;
  RecordProperty("microseconds_a_run", static_cast<int>(1e6 * each_s));
  EXPECT_LT(each_s, 0.004);
  EXPECT_GT(each_s, 0);
}
