// ariadne-experiment as its user sees it, without a process of its own.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "../batch/stand_in.h"
#include "../shipped_datasets.h"
#include "ariadne/process/find_program.h"
#include "experiment_app.h"

namespace fs = std::filesystem;

namespace {

const std::string kSmall =
    (ariadne::test::shippedDatasets().parent_path() / "ini" / "paper" / "small.ini").string();

class ExperimentApp : public StandIn {
 protected:
  int run(const std::vector<std::string>& args) {
    std::ostringstream out_stream;
    std::ostringstream err_stream;
    const int code = ariadne::runExperimentApp(args, out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
    return code;
  }
  int runInto(const std::string& name, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", ini().string(), "--out", at(name), "--jobs", "4"});
    return run(more);
  }
  std::string at(const std::string& name) const { return (folder / name).string(); }
  std::string table(const std::string& name, const std::string& format = "text") {
    EXPECT_EQ(run({"table", at(name), "--format", format}), 0) << err;
    return out;
  }
  bool says(const std::string& text) const { return (out + err).find(text) != std::string::npos; }

  std::string out;
  std::string err;
};

}  // namespace

TEST_F(ExperimentApp, TheShippedExperimentComesToTheSameBytesInSlices) {
  ASSERT_EQ(run({"run", kSmall, "--out", at("a"), "--jobs", "2", "--last", "2"}), 0) << err;
  EXPECT_NE(out.find("recovery  2     0       2/2 (100 %)"), std::string::npos) << out;
  EXPECT_TRUE(says("4 runs in ")) << err;
  ASSERT_EQ(run({"run", kSmall, "--out", at("b"), "--jobs", "1", "--last", "1"}), 0) << err;
  ASSERT_EQ(run({"run", kSmall, "--out", at("b"), "--last", "2", "--dry-run"}), 0) << err;
  EXPECT_TRUE(says("4 runs, 4 of them different, 2 finished")) << out;
  EXPECT_TRUE(says("recovery: 2 seeds, 1 finished")) << out;
  EXPECT_TRUE(says("by the 2 finished")) << out;
  ASSERT_EQ(run({"run", kSmall, "--out", at("b"), "--last", "2", "--quiet"}), 0) << err;
  EXPECT_EQ(out + err, "");
  for (const char* format : {"text", "csv", "markdown", "latex"})
    EXPECT_EQ(table("a", format), table("b", format));
}

TEST_F(ExperimentApp, APairedRunIsOfBothArms) {
  const fs::path loops =
      ariadne::test::shippedDatasets().parent_path() / "ini/paper/drives/small.ini";
  std::string text = "[experiment]\ntitle = Laps\n[figures]\nnames = ate_m\nsuccess = chosen\n";
  for (const char* arm : {"standard", "recovered"})
    text += std::string("[arm.") + arm +
            "]\nprogram = ariadne-loop-experiment\nconfig = " + loops.string() +
            "\nprefix = " + arm + "_\nset.filter.particles = 4\n";
  ariadne::io::writeWhole(ini(),
                          text + "[seeds]\nlast = 1\n[factor.laps]\nkey = --laps\nvalues = 1, 2\n");
  ASSERT_EQ(runInto("a"), 0) << err;
  EXPECT_TRUE(says("2 runs in ")) << "a run is of both arms: " << err;
  EXPECT_NE(table("a", "csv").find("\n2,recovered,1,0,"), std::string::npos) << out;
}

TEST_F(ExperimentApp, ARunOfOursWithATypoFailsThePlan) {
  writeExperiment(
      "[arm.third]\nprogram = ariadne-slam\nconfig = /dev/null\nset.filter.particels = 3\n");
  EXPECT_EQ(runInto("a"), 2);
  EXPECT_TRUE(says("there is no file /dev/null")) << err;
  ariadne::io::writeWhole(folder / "empty.ini", std::string_view("\n"));
  writeExperiment(
      "[arm.third]\nprogram = ariadne-slam\nconfig = empty.ini\nset.filter.particels = 3\n");
  EXPECT_EQ(runInto("a"), 2);
  EXPECT_TRUE(says("the nearest is \"particles\"")) << err;
  writeExperiment("[arm.third]\nprogram = ariadne-slam\nconfig = empty.ini\n");
  EXPECT_EQ(runInto("a"), 2);
  EXPECT_TRUE(says("names a log: dataset = LOG")) << err;
  EXPECT_FALSE(fs::exists(at("a")));
}

TEST_F(ExperimentApp, FailedRunsAreToldAndDoneAgainWhenAsked) {
  writeProgram("[ $seed = 2 ] && [ ! -e \"$here/well\" ] && { echo 'bad luck' >&2; exit 3; }");
  writeExperiment("[seeds]\nlast = 4\n");
  EXPECT_EQ(runInto("a"), 1);
  EXPECT_TRUE(says("seed 2, first: exit code 3")) << err;
  EXPECT_TRUE(says("--again-failed")) << err;
  EXPECT_EQ(run({"status", at("a")}), 0);
  EXPECT_TRUE(says("8 runs, 6 finished, 2 failed, 0 to do")) << out;
  EXPECT_TRUE(says("exit code 3: bad luck")) << out;
  EXPECT_EQ(runInto("a"), 1) << "a failure is a result";
  EXPECT_FALSE(says("runs in ")) << err;
  ariadne::io::writeWhole(folder / "well", std::string_view("x"));
  EXPECT_EQ(runInto("a", {"--again-failed"}), 0) << err;
  EXPECT_TRUE(says("2 runs in ")) << err;
  runInto("b");
  EXPECT_EQ(table("a"), table("b"));
}

TEST_F(ExperimentApp, PlotsAndPageAreWrittenWhenRunsEnd) {
  writeExperiment("[seeds]\nlast = 3\n[limits]\nkeep_files = yes\n[plots]\nfigures = value\n");
  ASSERT_EQ(runInto("a"), 0) << err;
  EXPECT_TRUE(says("a/report.html")) << err;
  const std::string page = ariadne::io::readWhole(folder / "a" / "report.html");
  EXPECT_NE(page.find("set.a.second = yes"), std::string::npos) << "the INI";
  EXPECT_NE(page.find("<td>set.all</td>"), std::string::npos) << "the arms' difference";
  fs::remove(folder / "a" / "report.html");
  ASSERT_EQ(run({"report", at("a")}), 0) << err;
  EXPECT_EQ(ariadne::io::readWhole(folder / "a" / "report.html"), page);
  if (ariadne::process::findInPath("gnuplot").empty()) GTEST_SKIP() << "gnuplot-nox is missing";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "a" / "plots"), {}), 2);
  fs::remove_all(folder / "a" / "plots");
  ASSERT_EQ(run({"plot", at("a")}), 0) << err;
  EXPECT_TRUE(fs::exists(folder / "a" / "plots" / "value.svg"));
  EXPECT_TRUE(fs::exists(folder / "a" / "plots" / "value.png"));
}

TEST_F(ExperimentApp, WithoutGnuplotOnlyThePlotsAreMissing) {
  writeExperiment("[seeds]\nlast = 1\n");
  const std::string path = std::getenv("PATH");
  fs::create_directory(folder / "bin");
  for (const char* tool : {"grep", "sh", "cat"})
    fs::create_symlink(ariadne::process::findInPath(tool), folder / "bin" / tool);
  ::setenv("PATH", at("bin").c_str(), 1);
  EXPECT_EQ(runInto("a"), 0) << err;
  EXPECT_TRUE(says("no plots: ")) << err;
  EXPECT_TRUE(says("install gnuplot-nox")) << err;
  EXPECT_TRUE(fs::exists(folder / "a" / "report.html"));
  EXPECT_EQ(run({"plot", at("a")}), 1);
  ::setenv("PATH", path.c_str(), 1);
}

TEST_F(ExperimentApp, AnotherExperimentsFolderIsRefused) {
  writeExperiment("[seeds]\nlast = 1\n");
  ASSERT_EQ(runInto("a"), 0) << err;
  writeExperiment("[seeds]\nlast = 2\n");
  EXPECT_EQ(runInto("a"), 0) << "more seeds of the same experiment: " << err;
  writeExperiment("[seeds]\nlast = 1\n", "Another");
  EXPECT_EQ(runInto("a"), 2);
  EXPECT_TRUE(says("holds the results of \"Test\"")) << err;
}

TEST_F(ExperimentApp, AChangedArmIsRunAgainTheOtherIsKept) {
  writeExperiment("[seeds]\nlast = 3\n");
  ASSERT_EQ(runInto("a"), 0) << err;
  std::string text = ariadne::io::readWhole(ini());
  text.replace(text.find("set.a.second = yes"), 18, "set.a.second = yes\nset.a.more = 1");
  ariadne::io::writeWhole(ini(), text);
  ASSERT_EQ(runInto("a"), 0) << err;
  EXPECT_TRUE(says("3 runs in ")) << err;
}

TEST_F(ExperimentApp, AFolderThatCannotBeWritten) {
  writeExperiment("[seeds]\nlast = 6\n");
  EXPECT_EQ(runInto("arm.ini/x"), 1);
  EXPECT_TRUE(says("cannot make the folder")) << err;
  // As of a disk that fills up on the way: results cannot be stored from some moment on. A run goes on
  // while the one before is stored, so it waits for the six of seeds 1 to 3.
  writeProgram(
      "[ $seed = 4 ] && mkdir \"$here/gone\" && "
      "until [ $(ls \"$here/a/runs\" | wc -l) = 6 ]; do sleep 0.01; done && "
      "mv \"$here/a/runs\" \"$here/gone\" && echo > \"$here/a/runs\"");
  EXPECT_EQ(run({"run", ini().string(), "--out", at("a"), "--jobs", "1"}), 1);
  EXPECT_TRUE(says("cannot write")) << err;
  EXPECT_TRUE(says("finished runs are kept; the same command goes on")) << err;
  fs::remove(folder / "a" / "runs");
  fs::rename(folder / "gone" / "runs", folder / "a" / "runs");
  EXPECT_EQ(runInto("a"), 0) << err;
  EXPECT_TRUE(says("6 runs in ")) << "those of seeds 1 to 3 were kept: " << err;
}

TEST_F(ExperimentApp, WrongUse) {
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"run", ini().string()}), 2);
  EXPECT_TRUE(says("--out")) << err;
  EXPECT_EQ(run({"run", at("none.ini"), "--out", at("a")}), 1);
  EXPECT_TRUE(says("none.ini")) << err;
  EXPECT_EQ(run({"table", at("none")}), 2);
  EXPECT_TRUE(says("no results folder")) << err;
  for (const char* slice : {"0/3", "4/3", "3", "a/b", "1/3x"})
    EXPECT_EQ(run({"work", at("none"), "--slice", slice}), 2);
  EXPECT_TRUE(says("as 3/10")) << err;
  EXPECT_EQ(runInto("a", {"--first", "9", "--last", "2"}), 2);
  EXPECT_EQ(runInto("a", {"--jobs", "0"}), 2);
  EXPECT_EQ(run({"table", at("a"), "--format", "html"}), 2);
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_TRUE(says("ariadne-experiment run ini/paper/small.ini")) << out;
  EXPECT_FALSE(fs::exists(at("a")));
}
