#include "cluster_status.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <map>
#include <ostream>

#include "active_slices.h"
#include "ariadne/cluster/parallel_command.h"

namespace ariadne::experiment_app {
namespace {

using cluster::Submission;
using Counts = std::map<std::string, std::size_t>;

std::string listText(const Counts& counts) {
  std::string text;
  for (const auto& [what, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  return text;
}

void printSlurmJob(const Submission& s, const cluster::Queue& queue, std::string& sacct_problem,
                   std::ostream& out) {
  Counts active;
  std::string id = s.id;
  for (const cluster::Task& task : queue.tasks) {
    if (task.name != s.name) continue;
    const bool told = task.reason.empty() || task.reason == "None";
    ++active[told ? task.state : fmt::format("{} ({})", task.state, task.reason)];
    id = task.id;
  }
  if (id.empty()) return;  // a script that was not handed over, or refused
  fmt::print(out, "Slurm job {} (jobs/{}): {} slices handed out", id, s.number, s.handed.size());
  if (queue.problem.empty())
    fmt::print(out, "; squeue: {}", active.empty() ? "none waits or runs" : listText(active));
  if (sacct_problem.empty()) {
    const cluster::Account account = cluster::askSacct(id);
    sacct_problem = account.problem;
    if (!account.states.empty()) fmt::print(out, "; sacct: {}", listText(account.states));
  }
  out << "\n";
}

}  // namespace

void printClusterStatus(const batch::Plan& plan, const batch::Store& store, std::ostream& out) {
  const cluster::Submissions jobs(store.folder());
  const auto submissions = jobs.all();
  const cluster::Queue queue = askAbout(submissions);
  std::string sacct_problem;
  bool has_slurm = false;
  for (const Submission& s : submissions) {
    has_slurm = has_slurm || s.engine == "slurm";
    if (s.engine == "slurm") {
      printSlurmJob(s, queue, sacct_problem, out);
      continue;
    }
    const auto counts = cluster::readJoblog(jobs.folder(s) / "joblog.tsv");
    fmt::print(out, "GNU parallel (jobs/{}): {} slices handed out, {} ended, {} of them badly\n",
               s.number, s.handed.size(), counts.ended, counts.failed);
  }
  if (!has_slurm) return;
  if (!queue.problem.empty())
    fmt::print(out, "Of Slurm's queue nothing is known: {}\n", queue.problem);
  if (!sacct_problem.empty())
    fmt::print(out, "Of tasks that ended Slurm says nothing: {}\n", sacct_problem);
  // A slice of its own for each run: which have no result and nobody who will do them.
  const std::size_t runs = batch::distinctRuns(plan).size();
  const auto lost = cluster::openSlices(plan, store, runs, activeSlices(submissions, queue, store));
  if (queue.problem.empty() && !lost.empty())
    fmt::print(out,
               "{} runs are to do and in no task that waits or runs: submit again hands them out\n",
               lost.size());
}

}  // namespace ariadne::experiment_app
