// Which slices are handed out, what is kept of that, and GNU parallel's command and log.
#include <algorithm>

#include "../batch/stand_in.h"
#include "ariadne/batch/schedule.h"
#include "ariadne/cluster/parallel_command.h"
#include "ariadne/cluster/slices.h"
#include "ariadne/cluster/submission.h"
#include "ariadne/core/error.h"

using namespace ariadne;
namespace fs = std::filesystem;
using Numbers = std::vector<std::size_t>;

namespace {

class HandingOut : public StandIn {
 protected:
  void SetUp() override {
    StandIn::SetUp();
    writeExperiment("[seeds]\nlast = 5\n");
    plan = batch::planOf(batch::readExperiment(ini()));
    store().writePlan(plan);
  }
  batch::Store store() const { return batch::Store(results()); }
  void doSlice(std::size_t slice, std::size_t slices) const {
    batch::ScheduleOptions options;
    options.slice = slice;
    options.slices = slices;
    batch::doRuns(store(), plan, options);
  }
  Numbers open(std::size_t slices, const std::vector<cluster::Slice>& active = {}) const {
    return cluster::openSlices(plan, store(), slices, active);
  }
  batch::Plan plan;
};

}  // namespace

TEST_F(HandingOut, SlicesAreThoseThatTheWorkerDoes) {
  EXPECT_EQ(open(4), (Numbers{1, 2, 3, 4}));
  doSlice(2, 4);
  doSlice(4, 4);
  EXPECT_EQ(open(4), (Numbers{1, 3}));
  EXPECT_EQ(open(2), (Numbers{1})) << "2 and 4 of 4 are 2 of 2";
  EXPECT_EQ(open(3), (Numbers{1, 2, 3}));
  store().forget(plan.runs[3].key);
  EXPECT_EQ(open(4), (Numbers{1, 3, 4}));
}

TEST_F(HandingOut, WhatSomebodyLivingDoesIsNotHandedOutAgain) {
  EXPECT_EQ(open(4, {{1, 4}, {3, 4}}), (Numbers{2, 4}));
  EXPECT_EQ(open(4, {{1, 2}}), (Numbers{2, 4})) << "a running task of another cut";
  EXPECT_EQ(open(2, {{1, 4}}), (Numbers{1, 2})) << "half of the first is nobody's";
  EXPECT_EQ(open(4, {{1, 1}}), Numbers{});
  EXPECT_EQ(open(100), (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10})) << "empty slices are not";
}

TEST_F(HandingOut, WhatFailedIsAgainNobodysUnlessItsTaskWaits) {
  const std::set<std::string> again{plan.runs[1].key};  // in slice 2 of 4
  const auto slices = [&](bool waits) {
    return cluster::openSlices(plan, store(), 4, {{1, 4}, {2, 4, waits}}, again);
  };
  EXPECT_EQ(slices(false), (Numbers{2, 3, 4}));
  EXPECT_EQ(slices(true), (Numbers{3, 4}));
}

TEST_F(HandingOut, RangesAsSbatchTakesThem) {
  EXPECT_EQ(cluster::rangesText({}), "");
  EXPECT_EQ(cluster::rangesText({7}), "7");
  EXPECT_EQ(cluster::rangesText({1, 2, 3, 4, 7, 9, 10}), "1-4,7,9-10");
}

TEST_F(HandingOut, SubmissionsHaveNamesOfTheirOwnAndAreReadBack) {
  const cluster::Submissions jobs(results());
  EXPECT_TRUE(jobs.all().empty());
  cluster::Submission first = jobs.begin("slurm");
  const cluster::Submission second = jobs.begin("parallel");
  EXPECT_NE(first.name, second.name);
  EXPECT_NE(first.name, cluster::Submissions(folder / "other").begin("slurm").name);
  EXPECT_TRUE(jobs.all().empty()) << "begun only";
  first.id = "17";
  first.slices = 4;
  first.handed = {1, 3};
  first.plan = "abc";
  jobs.put(second);
  jobs.put(first);
  const auto all = jobs.all();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, "17");
  EXPECT_EQ(all[0].handed, (Numbers{1, 3}));
  EXPECT_EQ(all[0].plan, "abc");
  EXPECT_EQ(all[1].engine, "parallel");
  const std::string good = io::readWhole(jobs.folder(first) / "job.json");
  for (const char* slices : {"-4", "4.5", "1e300", "\"4\"", "0"}) {
    std::string bad = good;
    bad.replace(bad.find("\"slices\":4") + 9, 1, slices);
    io::writeWhole(jobs.folder(first) / "job.json", bad);
    try {
      jobs.all();
      FAIL() << slices;
    } catch (const core::Error& e) {
      EXPECT_NE(std::string(e.what()).find("slices is "), std::string::npos) << e.what();
    }
  }
  io::writeWhole(jobs.folder(first) / "job.json", std::string_view("{\"number\": 1}"));
  EXPECT_THROW(jobs.all(), core::Error);
}

TEST_F(HandingOut, ParallelTakesCoresAndNamesIntoAccount) {
  const cluster::WorkerCall worker{"/opt/a b/ariadne-experiment", "/it's/shared", 9, 2, 2};
  cluster::ParallelOptions options{"/x/hosts", 0};
  const auto words = cluster::parallelCommand(worker, options, "/x/log", {2, 5});
  const auto has = [&](const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  EXPECT_TRUE(
      has("'/opt/a b/ariadne-experiment' work '/it'\\''s/shared' --slice {}/9 --jobs 2 "
          "--quiet"));
  EXPECT_TRUE(has("25%")) << "four cores a slice";
  EXPECT_EQ((std::vector<std::string>(words.end() - 3, words.end())),
            (std::vector<std::string>{":::", "2", "5"}));
  options.host_limit = 3;
  EXPECT_EQ(cluster::parallelCommand(worker, options, "/x/log", {1}).at(10), "3");
}

TEST_F(HandingOut, AJoblogCountsTheLastTry) {
  EXPECT_EQ(cluster::readJoblog(folder / "none").ended, 0U);
  io::writeWhole(folder / "log", std::string_view("Seq\tHost\tStarttime\tJobRuntime\tSend\tReceive"
                                                  "\tExitval\tSignal\tCommand\n"
                                                  "1\tssh -p 2 a\t1.5\t2\t0\t0\t0\t0\tx work\n"
                                                  "2\tb\t1.5\t2\t0\t0\t255\t0\tx work\n"
                                                  "3\tb\t1.5\t2\t0\t0\t1\t0\tx work\n"
                                                  "2\ta\t1.5\t2\t0\t0\t0\t0\tx work\n"
                                                  "4\ta\t1.5"));
  const auto counts = cluster::readJoblog(folder / "log");
  EXPECT_EQ(counts.ended, 3U);
  EXPECT_EQ(counts.failed, 1U);
}
