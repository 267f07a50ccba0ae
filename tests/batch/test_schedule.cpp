#include <algorithm>
#include <thread>

#include "ariadne/batch/claims.h"
#include "ariadne/batch/schedule.h"
#include "ariadne/core/error.h"
#include "stand_in.h"

using namespace ariadne;
namespace fs = std::filesystem;

namespace {

class Scheduling : public StandIn {
 protected:
  /// Plans and does the experiment.
  batch::ScheduleEnd run() {
    plan = batch::planOf(batch::readExperiment(ini()));
    store().writePlan(plan);
    options.jobs = 4;
    return batch::doRuns(store(), plan, options);
  }
  batch::Store store() const { return batch::Store(results()); }
  batch::RunResult resultOf(std::size_t run) const {
    return store().result(plan.runs[run].key).value_or(batch::RunResult());
  }
  std::size_t entriesOf(const std::string& name) const {
    std::error_code ignored;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(results() / name, ignored), {}));
  }
  batch::Plan plan;
  batch::ScheduleOptions options;
};

}  // namespace

TEST_F(Scheduling, KeepsFiguresTimesAndNothingElse) {
  writeExperiment("[seeds]\nfirst = 3\nlast = 6\n");
  std::size_t told = 0;
  options.tell = [&](const batch::ScheduleProgress& p) { told = p.finished; };
  const auto end = run();
  EXPECT_EQ(end.done, 8U);
  EXPECT_EQ(end.failed, 0U);
  EXPECT_FALSE(end.stopped);
  EXPECT_EQ(told, 8U);
  const auto r = resultOf(0);
  EXPECT_EQ(r.about, "seed 3, first");
  EXPECT_EQ(r.figures, (batch::Figures{{"ok", 0}, {"value", 10}}));
  EXPECT_GT(r.wall_s, 0);
  EXPECT_GT(r.cpu_s, 0);
  EXPECT_EQ(r.host, batch::hostName());
  EXPECT_FALSE(fs::exists(results() / "scratch"));
  EXPECT_EQ(entriesOf("claims"), 1U);
  EXPECT_EQ(entriesOf("claims/owners"), 0U);
  EXPECT_EQ(run().done, 0U) << "all have a result";
}

TEST_F(Scheduling, ErrorsAgainstATruthAreOfAnyProgramsTrajectory) {
  const std::string path = "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n3 1 1 0 0 0 0 1\n";
  io::writeWhole(folder / "truth.tum", path);
  writeProgram("[ $arm = 1 ] && cp \"$here/truth.tum\" \"$out/trajectory.tum\"");
  writeExperiment("[seeds]\nlast = 1\n");
  std::string text = io::readWhole(ini());
  for (std::size_t at = 0; (at = text.find("config = arm.ini", at)) != std::string::npos; at += 20)
    text.insert(at, "truth = truth.tum\n"), at += 18;
  io::writeWhole(ini(), text);
  EXPECT_EQ(run().failed, 1U);
  EXPECT_NEAR(resultOf(0).figures.at("ate_rmse_m"), 0, 1e-9);
  EXPECT_NE(resultOf(1).failure.find("trajectory.tum"), std::string::npos);
}

TEST_F(Scheduling, AKillThatWasMeantForTheWorkerTooIsNoResult) {
  writeProgram("touch \"$here/killed\"; kill -9 $$");
  writeExperiment("[seeds]\nlast = 1\n");
  std::optional<std::chrono::steady_clock::time_point> killed;
  options.stop = [&] {  // our own signal comes a little later
    const auto now = std::chrono::steady_clock::now();
    if (!killed && fs::exists(folder / "killed")) killed = now;
    return killed && now - *killed > std::chrono::milliseconds(100);
  };
  const auto end = run();
  EXPECT_TRUE(end.stopped);
  EXPECT_EQ(end.done, 0U);
  EXPECT_EQ(entriesOf("runs"), 0U);
  EXPECT_EQ(entriesOf("claims"), 1U);
}

TEST_F(Scheduling, ACrashAHangAndAKillCostOnlyTheirRuns) {
  writeProgram(R"(case $seed in
  1) echo "about to crash" >&2; kill -SEGV $$;;
  2) sleep 100;;
  3) kill -9 $$;;
  4) echo "no luck" >&2; exit 7;;
  5) exit 0;;
  6) echo "not json" > "$out/summary.json"; exit 0;;
  7) sleep 100 & ;;
esac)");
  writeExperiment("[seeds]\nlast = 8\n[limits]\ntime_s = 0.7\n");
  const auto end = run();
  EXPECT_EQ(end.done, 16U);
  EXPECT_EQ(end.failed, 12U);
  EXPECT_LT(end.wall_s, 5);
  EXPECT_EQ(resultOf(0).failure, "killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(resultOf(0).last_words, "about to crash\n");
  EXPECT_EQ(resultOf(2).failure, "took longer than its limit of 0.7 s");
  EXPECT_EQ(resultOf(4).failure, "killed by signal 9 (Killed)");
  EXPECT_EQ(resultOf(6).failure, "exit code 7");
  EXPECT_EQ(resultOf(6).last_words, "no luck\n");
  EXPECT_NE(resultOf(8).failure.find("summary.json"), std::string::npos) << resultOf(8).failure;
  EXPECT_NE(resultOf(10).failure.find("is no JSON"), std::string::npos) << resultOf(10).failure;
  EXPECT_EQ(resultOf(12).failure, "") << "what it leaves running does not hold it up";
  EXPECT_EQ(resultOf(14).failure, "");
}

TEST_F(Scheduling, OfEndlessWordsTheLastAreKept) {
  writeProgram("yes 'a line of no use' | head -c 20000000 >&2; echo last >&2; exit 1");
  writeExperiment("[seeds]\nlast = 1\n");
  EXPECT_EQ(run().failed, 2U);
  const std::string words = resultOf(0).last_words;
  EXPECT_LE(words.size(), 4000U);
  EXPECT_EQ(words.substr(words.size() - 5), "last\n");
}

TEST_F(Scheduling, AFullDiskIsNoResultOfARun) {
  writeProgram("[ $seed = 3 ] && { echo 'cannot write x: No space left on device' >&2; exit 1; }");
  writeExperiment("[seeds]\nlast = 4\n");
  try {
    run();
    FAIL();
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find("No space left"), std::string::npos) << e.what();
  }
  for (const auto& [key, result] : store().results(plan)) EXPECT_EQ(result.failure, "");
  EXPECT_EQ(entriesOf("claims/owners"), 0U);
  writeProgram("");
  EXPECT_EQ(run().failed, 0U);
}

TEST_F(Scheduling, StopsKillsAndKeepsWhatIsDone) {
  writeProgram("[ $seed -gt 2 ] && sleep 100");
  writeExperiment("[seeds]\nlast = 9\n");
  std::size_t finished = 0;
  options.tell = [&](const batch::ScheduleProgress& p) { finished = p.finished; };
  options.stop = [&] { return finished == 4; };
  const auto end = run();
  EXPECT_TRUE(end.stopped);
  EXPECT_LT(end.wall_s, 10);
  EXPECT_EQ(store().results(plan).size(), 4U);
  EXPECT_EQ(entriesOf("claims"), 1U);
  EXPECT_FALSE(fs::exists(results() / "scratch"));
}

TEST_F(Scheduling, SlicesAreThePlan) {
  writeExperiment("[seeds]\nlast = 5\n");
  plan = batch::planOf(batch::readExperiment(ini()));
  store().writePlan(plan);
  std::size_t done = 0;
  options.slices = 3;
  for (options.slice = 1; options.slice <= 3; ++options.slice)
    done += batch::doRuns(store(), plan, options).done;
  EXPECT_EQ(done, 10U);
  EXPECT_EQ(store().results(plan).size(), 10U);
}

TEST_F(Scheduling, WaitsForTheRunsOfOthersAndTakesThoseOfTheDead) {
  writeExperiment("[seeds]\nlast = 2\n");
  plan = batch::planOf(batch::readExperiment(ini()));
  store().writePlan(plan);
  // Another machine has two runs: it finishes one and gives no more sign of life for the other.
  const std::string owner = "elsewhere-77-99";
  const fs::path file = results() / "claims" / "owners" / owner;
  fs::create_directories(file.parent_path());
  io::writeWhole(file, owner);
  for (const std::size_t i : {0U, 1U})
    fs::create_hard_link(file, results() / "claims" / (plan.runs[i].key + ".1"));
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    batch::RunResult r;
    r.key = plan.runs[0].key;
    r.host = "elsewhere";
    store().put(r);
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::minutes(4));
  });
  const auto end = batch::doRuns(store(), plan, options);
  other.join();
  EXPECT_EQ(end.done, 3U);
  EXPECT_EQ(resultOf(0).host, "elsewhere");
  EXPECT_EQ(resultOf(1).host, batch::hostName());
}

TEST_F(Scheduling, AChangedProgramOrDataIsPlannedAgainFirst) {
  run();
  store().forget(plan.runs[0].key);
  writeProgram("# a new version");
  try {
    batch::doRuns(store(), plan, options);
    FAIL();
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find("plan again"), std::string::npos) << e.what();
  }
  EXPECT_EQ(run().done, 20U);
}

TEST_F(Scheduling, FilesAreKeptWhereAskedFor) {
  writeProgram("echo map > \"$out/map.txt\"");
  writeExperiment("[seeds]\nlast = 1\n[limits]\nkeep_files = true\n");
  run();
  EXPECT_EQ(io::readWhole(store().files(plan.runs[1].key) / "map.txt"), "map\n");
}

TEST_F(Scheduling, AProgramBuiltAgainMeanwhileGivesNoResult) {
  writeExperiment("[seeds]\nlast = 4\n");
  writeProgram("[ $seed = 3 ] && echo '# of a later version' >> \"$here/program.sh\"");
  plan = batch::planOf(batch::readExperiment(ini()));
  store().writePlan(plan);
  try {
    batch::doRuns(store(), plan, options);  // one at a time
    FAIL() << "under the old program's keys";
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find("program.sh is not what it was"), std::string::npos)
        << e.what();
  }
  EXPECT_EQ(store().results(plan).size(), 4U) << "of seeds 1 and 2";
  EXPECT_EQ(entriesOf("claims"), 1U) << "given back";
}
