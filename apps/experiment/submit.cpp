#include "submit.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "active_slices.h"
#include "ariadne/batch/run_counts.h"
#include "ariadne/cluster/slices.h"
#include "ariadne/cluster/slurm_script.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/call.h"
#include "folder_steps.h"
#include "submit_checks.h"

namespace ariadne::experiment_app {
namespace {

using batch::Plan;
using batch::Store;
using cluster::Submission;
using cluster::Submissions;

/// Slurm numbers tasks up to MaxArraySize, without a word of its administrator below 1001.
constexpr std::size_t kMostSlices = 1000;

cluster::WorkerCall workerFor(const Options& o, const Plan& plan, const Store& store) {
  std::error_code ignored;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::size_t runs = batch::distinctRuns(plan).size();
  return {self.parent_path() / "ariadne-experiment", store.folder(),
          o.handed_slices > 0 ? o.handed_slices : std::min(runs, kMostSlices), o.jobs,
          std::max(1, plan.limits.threads)};
}

/// Slices for this call; says so when there are none.
std::vector<std::size_t> slicesFor(const Options& o, const Plan& plan, const Store& store,
                                   std::size_t slices, const std::set<std::string>& again,
                                   std::ostream& out, std::ostream& err) {
  const auto submissions = Submissions(store.folder()).all();
  const cluster::Queue queue = askAbout(submissions);
  if (!queue.problem.empty() && !o.script_only && o.engine == Engine::slurm)
    throw core::Error(fmt::format(
        "which slices still live cannot be known, nothing was submitted: {}", queue.problem));
  if (!queue.problem.empty())
    fmt::print(err, "ariadne-experiment: which slices still live is not known: {}\n",
               queue.problem);
  const auto active = activeSlices(submissions, queue, store);
  auto open = cluster::openSlices(plan, store, slices, active, again);
  if (open.empty() && active.empty())
    fmt::print(out, "Nothing is left to do: ariadne-experiment collect {}\n",
               store.folder().string());
  else if (open.empty())
    fmt::print(out, "Nothing to hand out: {} tasks of Slurm's have all that is left to do\n",
               active.size());
  return open;
}

int submitSlurm(const Options& o, const Store& store, const cluster::WorkerCall& worker,
                Submission s, std::ostream& out) {
  const Submissions jobs(store.folder());
  const auto script = jobs.folder(s) / "script.sbatch";
  io::writeWhole(script, cluster::slurmScript(worker, o.slurm, s.name, jobs.folder(s), s.handed));
  // Before sbatch: should we die in between, the job is still known by its name.
  jobs.put(s);
  if (o.script_only) {
    fmt::print(out, "{} slices in {}: read it, change it, hand it over with sbatch\n",
               s.handed.size(), script.string());
    return 0;
  }
  s.id = cluster::submitToSlurm(script);
  jobs.put(s);
  fmt::print(out,
             "Slurm job {}: {} slices (logs in {})\n"
             "How far: ariadne-experiment status {}\n"
             "At the end: ariadne-experiment collect {}\n",
             s.id, s.handed.size(), jobs.folder(s).string(), o.folder, o.folder);
  return 0;
}

int runParallel(const Options& o, const Plan& plan, const Store& store,
                const cluster::WorkerCall& worker, const Submission& s, std::ostream& out,
                std::ostream& err) {
  const Submissions jobs(store.folder());
  jobs.put(s);
  fmt::print(out, "{} slices by GNU parallel (log: {})\n", s.handed.size(),
             (jobs.folder(s) / "joblog.tsv").string());
  out.flush();
  process::callInForeground(
      cluster::parallelCommand(worker, o.parallel, jobs.folder(s) / "joblog.tsv", s.handed));
  const batch::Counts counts = batch::countRuns(plan, store.results(plan));
  const std::size_t left = counts.planned - counts.finished - counts.failed;
  fmt::print(out, "{} of {} runs finished, {} failed\n", counts.finished, counts.planned,
             counts.failed);
  if (left > 0)
    fmt::print(err, "ariadne-experiment: {} runs are left: the same command hands them out again\n",
               left);
  return left > 0 || counts.failed > 0 ? 1 : 0;
}

}  // namespace

int submit(const Options& o, std::ostream& out, std::ostream& err) {
  checkSubmit(o);
  const Plan plan = planFor(o);
  if (o.engine == Engine::slurm) warnOfTime(o, plan, err);
  const Store store(o.folder);
  store.writePlan(plan);
  const auto again = o.again_failed ? forgetFailed(plan, store) : std::set<std::string>();
  const cluster::WorkerCall worker = workerFor(o, plan, store);
  const auto slices = slicesFor(o, plan, store, worker.slices, again, out, err);
  if (slices.empty()) return 0;
  Submission s =
      Submissions(store.folder()).begin(o.engine == Engine::slurm ? "slurm" : "parallel");
  s.slices = worker.slices;
  s.handed = slices;
  s.plan = planHash(store);
  return o.engine == Engine::slurm ? submitSlurm(o, store, worker, s, out)
                                   : runParallel(o, plan, store, worker, s, out, err);
}

}  // namespace ariadne::experiment_app
