// ariadne-experiment submit, status and collect, with stand-ins for Slurm's commands.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <sstream>

#include "../batch/stand_in.h"
#include "ariadne/process/find_program.h"
#include "experiment_app.h"

namespace fs = std::filesystem;

namespace {

class Submit : public StandIn {
 protected:
  void SetUp() override {
    StandIn::SetUp();
    writeExperiment("[seeds]\nlast = 4\n");
    path_ = ::getenv("PATH");
    fs::create_directories(folder / "bin");
    ::setenv("PATH", ((folder / "bin").string() + ":" + path_).c_str(), 1);
    command("sbatch", "cp \"$2\" \"$here/submitted\"; echo \"17;cluster\"");
    command("squeue", "cat \"$here/queue\" 2>/dev/null; true");
    command("sacct", "echo 'Slurm accounting storage is disabled' >&2; exit 1");
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    StandIn::TearDown();
  }
  void command(const std::string& name, const std::string& body) const {
    const fs::path file = folder / "bin" / name;
    ariadne::io::writeWhole(file, "#!/bin/sh\nhere='" + folder.string() + "'\n" + body + "\n");
    fs::permissions(file, fs::perms::owner_all);
  }
  /// Only these commands, and those that tests need, are in PATH.
  void withoutSlurm() const {
    for (const char* name : {"sbatch", "squeue", "sacct"}) fs::remove(folder / "bin" / name);
    for (const char* name : {"sh", "cat", "grep"})
      fs::create_symlink(ariadne::process::findInPath(name), folder / "bin" / name);
    ::setenv("PATH", (folder / "bin").c_str(), 1);
  }
  /// squeue's answer: name, job, slice, state, reason.
  void queue(const std::string& lines) const { ariadne::io::writeWhole(folder / "queue", lines); }

  int run(const std::vector<std::string>& args) {
    std::ostringstream out_stream;
    std::ostringstream err_stream;
    const int code = ariadne::runExperimentApp(args, out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
    return code;
  }
  int submit(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"submit", ini().string(), "--out", results().string()});
    return run(more);
  }
  int work(const std::string& slice) { return run({"work", results().string(), "--slice", slice}); }
  std::string submitted() const { return ariadne::io::readWhole(folder / "submitted"); }
  std::string nameOfJob() const {
    const std::string text = submitted();
    const std::size_t at = text.find("--job-name=") + 11;
    return text.substr(at, text.find('\n', at) - at);
  }
  bool says(const std::string& text) const { return (out + err).find(text) != std::string::npos; }
  bool handed(const std::string& array) const {
    return submitted().find("--array=" + array + "\n") != std::string::npos;
  }

  std::string out;
  std::string err;

 private:
  std::string path_;
};

}  // namespace

TEST_F(Submit, WritesThePlanAndHandsOutSlicesThenOnlyWhatIsMissing) {
  ASSERT_EQ(submit({"--slices", "4", "--array-limit", "2"}), 0) << err;
  EXPECT_TRUE(says("Slurm job 17: 4 slices")) << out;
  EXPECT_TRUE(handed("1-4%2")) << submitted();
  EXPECT_NE(submitted().find("/ariadne-experiment'\nfolder='" + results().string() + "'"),
            std::string::npos)
      << submitted();
  ASSERT_EQ(work("1/4"), 0) << err;
  ASSERT_EQ(work("3/4"), 0) << err;
  const std::string name = nameOfJob();
  queue(name + "|17|2|RUNNING|None\n" + name + "|17|4|PENDING|Resources\nother|9|1|RUNNING|None\n");
  ASSERT_EQ(submit({"--slices", "4"}), 0) << err;
  EXPECT_TRUE(says("Nothing to hand out: 2 tasks")) << out;
  queue(name + "|17|4|PENDING|Resources\n");
  ASSERT_EQ(submit({"--slices", "4"}), 0) << err;
  EXPECT_TRUE(handed("2")) << submitted();
  EXPECT_NE(nameOfJob(), name);
  queue("");
  ASSERT_EQ(submit({"--slices", "4"}), 0) << err;
  EXPECT_TRUE(handed("2,4")) << submitted();
  work("1/1");
  ASSERT_EQ(submit(), 0) << err;
  EXPECT_TRUE(says("Nothing is left to do: ariadne-experiment collect")) << out;
}

TEST_F(Submit, AChangedPlanIsNotWhatARunningTaskDoes) {
  ASSERT_EQ(submit({"--slices", "2", "--last", "2"}), 0) << err;
  const std::string name = nameOfJob();
  queue(name + "|17|1|RUNNING|None\n" + name + "|17|2|PENDING|Resources\n");
  ASSERT_EQ(submit({"--slices", "2"}), 0) << err;
  EXPECT_TRUE(handed("1")) << "the second reads the new plan when it starts: " << submitted();
}

TEST_F(Submit, CollectMakesTheTablesOfALocalRun) {
  ASSERT_EQ(submit({"--slices", "3"}), 0) << err;
  ASSERT_EQ(work("1/3"), 0) << err;
  EXPECT_EQ(run({"collect", results().string()}), 1);
  EXPECT_TRUE(says("5 of 8 runs have no result yet")) << err;
  EXPECT_FALSE(fs::exists(results() / "tables"));
  for (const char* slice : {"3/3", "2/3"}) ASSERT_EQ(work(slice), 0) << err;
  ASSERT_EQ(run({"collect", results().string()}), 0) << err;
  const std::string collected = out;
  const std::string local = (folder / "local").string();
  ASSERT_EQ(run({"run", ini().string(), "--out", local, "--jobs", "4"}), 0) << err;
  EXPECT_EQ(collected, out);
  for (const auto& [format, end] :
       {std::pair("text", "txt"), {"csv", "csv"}, {"markdown", "md"}, {"latex", "tex"}}) {
    ASSERT_EQ(run({"table", local, "--format", format}), 0) << err;
    EXPECT_EQ(ariadne::io::readWhole(results() / "tables" / (std::string("table.") + end)), out);
  }
}

TEST_F(Submit, FailedRunsAreToldAndHandedOutWhenAsked) {
  writeProgram("[ $seed = 2 ] && exit 3");
  ASSERT_EQ(submit({"--slices", "4"}), 0) << err;
  EXPECT_EQ(work("1/1"), 1);
  EXPECT_EQ(run({"collect", results().string()}), 1);
  EXPECT_TRUE(says("2 runs failed: submit with --again-failed")) << err;
  EXPECT_TRUE(fs::exists(results() / "tables" / "table.tex"));
  ASSERT_EQ(submit({"--slices", "4", "--again-failed"}), 0) << err;
  EXPECT_TRUE(handed("3-4")) << submitted();
  EXPECT_EQ(work("3/4"), 1);
  const std::string name = nameOfJob();
  queue(name + "|17|3|RUNNING|None\n" + name + "|17|4|PENDING|Resources\n");
  ASSERT_EQ(submit({"--slices", "4", "--again-failed"}), 0) << err;
  EXPECT_TRUE(handed("3")) << "its task is past the run that failed: " << submitted();
}

TEST_F(Submit, StatusSaysWhatSlurmSays) {
  ASSERT_EQ(submit({"--slices", "4"}), 0) << err;
  const std::string name = nameOfJob();
  queue(name + "|17|1|RUNNING|None\n" + name + "|17|2|PENDING|Priority\n" + name +
        "|17|3|PENDING|Priority\n");
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_TRUE(
      says("Slurm job 17 (jobs/1): 4 slices handed out; squeue: 2 PENDING (Priority), "
           "1 RUNNING"))
      << out;
  EXPECT_TRUE(says("Slurm accounting storage is disabled")) << out;
  EXPECT_TRUE(says("2 runs are to do and in no task that waits or runs")) << out;
  command("sacct", "printf 'COMPLETED\\nCANCELLED by 7\\nCOMPLETED\\n'");
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_TRUE(says("; sacct: 1 CANCELLED, 2 COMPLETED")) << out;
  command("squeue", "echo 'Unable to contact slurm controller' >&2; exit 1");
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_TRUE(says("Of Slurm's queue nothing is known: squeue: Unable to contact")) << out;
  command("squeue", "echo 'squeue: error: no controller' >&2; exit 1");
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_TRUE(says("nothing is known: squeue: error: no")) << out;
  command("squeue", "echo 'Unable to contact slurm controller' >&2; exit 1");
  EXPECT_EQ(submit(), 1) << "what lives may not be handed out twice";
  EXPECT_TRUE(says("nothing was submitted: squeue: Unable")) << err;
}

TEST_F(Submit, WithoutSlurmTheScriptCanBeHad) {
  withoutSlurm();
  EXPECT_EQ(submit(), 2);
  EXPECT_TRUE(says("slurm-client") && says("--script-only")) << err;
  EXPECT_FALSE(fs::exists(results())) << "said before anything is done";
  for (const char* number : {"1", "2"}) {
    ASSERT_EQ(submit({"--script-only", "--slices", "2"}), 0) << err;
    EXPECT_TRUE(says("jobs/" + std::string(number) + "/script.sbatch")) << out;
  }
  EXPECT_TRUE(says("which slices still live is not known")) << err;
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_TRUE(says("squeue is not here")) << out;
}

TEST_F(Submit, WhatSbatchSaysIsTold) {
  command("sbatch",
          "echo 'sbatch: error: Batch job submission failed: Invalid job array "
          "specification' >&2; exit 1");
  EXPECT_EQ(submit(), 1);
  EXPECT_TRUE(says("Invalid job array") && says("MaxArraySize")) << err;
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_FALSE(says("handed out;")) << out;
}

TEST_F(Submit, ASitesBannerIsNoAnswer) {
  command("sbatch",
          "printf 'Welcome to cluster9\\n2026-11-01: maintenance; be quick\\n12 nodes are down\\n"
          "4711;cluster9\\n\\nYou have 1000 CPU hours left.\\n'");
  ASSERT_EQ(submit({"--slices", "4"}), 0) << err;
  EXPECT_TRUE(says("Slurm job 4711: 4 slices")) << out;
  command("sacct", "printf 'WELCOME to us\\nAsk help@lab\\nCOMPLETED\\nCANCELLED by 7\\n'");
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_TRUE(says("; sacct: 1 CANCELLED, 1 COMPLETED\n")) << out;
}

TEST_F(Submit, AnAnswerWithoutANumberIsTold) {
  command("sbatch", "echo 'Submitted for tonight'");
  EXPECT_EQ(submit({"--slices", "4"}), 1);
  EXPECT_TRUE(says("no job's number in \"Submitted for tonight")) << err;
}

TEST_F(Submit, GnuParallelDoesTheSlices) {
  if (ariadne::process::findInPath("parallel").empty()) GTEST_SKIP() << "no GNU parallel";
  EXPECT_EQ(submit({"--engine", "parallel"}), 2);
  EXPECT_TRUE(says("--sshloginfile")) << err;
  const std::string hosts = (folder / "hosts").string();
  EXPECT_EQ(submit({"--engine", "parallel", "--sshloginfile", hosts}), 2);
  EXPECT_TRUE(says("there is no file")) << err;
  ariadne::io::writeWhole(hosts, std::string_view(":\n"));
  ASSERT_EQ(submit({"--engine", "parallel", "--sshloginfile", hosts, "--slices", "3"}), 0) << err;
  EXPECT_TRUE(says("8 of 8 runs finished")) << out;
  ASSERT_EQ(run({"status", results().string()}), 0) << err;
  EXPECT_TRUE(says("GNU parallel (jobs/1): 3 slices handed out, 3 ended, 0 of them badly")) << out;
  EXPECT_EQ(run({"collect", results().string()}), 0) << err;
  command("parallel", "echo 'parallel from moreutils' >&2; exit 1");
  EXPECT_EQ(submit({"--engine", "parallel", "--sshloginfile", hosts}), 2);
  EXPECT_TRUE(says("no GNU parallel")) << err;
}

TEST_F(Submit, WrongUse) {
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--array-limit", "0"},
                                             {"--time", "1h"},
                                             {"--slices", "0"},
                                             {"--engine", "pbs"},
                                             {"--mem", "much"},
                                             {"--first", "-1"},
                                             {"--engine", "0"},
                                             {"--sshloginfile", "x"},
                                             {"--engine", "parallel", "--time", "5"},
                                             {"--engine", "parallel", "--script-only"},
                                             {"--jobs", "0"}})
    EXPECT_EQ(submit(wrong), 2) << wrong[0];
  EXPECT_EQ(submit({"--engine", "pbs"}), 2);
  EXPECT_TRUE(says("--engine: pbs: takes one of parallel, slurm")) << err;
  EXPECT_EQ(run({"submit", ini().string(), "--out", results().string() + "\"", "--script-only"}),
            2);
  EXPECT_FALSE(fs::exists(results().string() + "\"")) << "said before anything is done";
  EXPECT_EQ(submit({"--host-limit", "2"}), 2);
  EXPECT_TRUE(says("--host-limit goes with --engine parallel")) << err;
  EXPECT_FALSE(fs::exists(results()));
  EXPECT_EQ(submit({"--time", "5"}), 0);
  EXPECT_TRUE(says("a longer run would never come to its end")) << err;
  EXPECT_EQ(run({"submit", "--help"}), 0);
  EXPECT_TRUE(says("--sshloginfile machines.txt") && says("With --engine slurm")) << out;
}
