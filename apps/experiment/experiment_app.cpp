#include "experiment_app.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <ostream>

#include "ariadne/batch/run_counts.h"
#include "ariadne/batch/schedule.h"
#include "ariadne/core/error.h"
#include "cluster_status.h"
#include "collect.h"
#include "dry_run.h"
#include "experiment_options.h"
#include "experiment_status.h"
#include "folder_steps.h"
#include "interrupt.h"
#include "results_output.h"
#include "run_program.h"
#include "run_progress.h"
#include "submit.h"

namespace ariadne {
namespace {

using namespace experiment_app;
using batch::Plan;
using batch::Store;

constexpr const char* kName = "ariadne-experiment";

/// Says on `err` when the results are not those of the whole plan.
void tellMissing(const Plan& plan, const ResultsOutput& results, std::ostream& err) {
  const batch::Counts counts = batch::countRuns(plan, results.results());
  if (counts.missing() > 0)
    fmt::print(err, "{}: {} of {} runs have a result\n", kName, counts.finished + counts.failed,
               counts.planned);
}

/// Table, plots and page of what is finished.
void showResults(const Options& o, const Plan& plan, const Store& store, std::ostream& out,
                 std::ostream& err) {
  const ResultsOutput results(plan, store);
  if (!o.quiet) tellMissing(plan, results, err);
  const bool is_table = o.command == Command::table || o.command == Command::run;
  if (is_table && !o.quiet) out << results.table(o.format);
  if (o.command == Command::plot) results.writePlots();
  if (o.command == Command::report || o.command == Command::run) results.writeReport(err);
  if (o.command == Command::publish) return results.exportTo(o.to, err);
  if (o.command != Command::table && !o.quiet)
    fmt::print(err, "{}\n",
               (store.folder() / (o.command == Command::plot ? "plots" : "report.html")).string());
}

void tellEnd(const Options& o, const batch::ScheduleEnd& end, std::ostream& err) {
  if (o.quiet || end.done == 0) return;
  fmt::print(err, "{} runs in {}, {:.1f} s of CPU; the runner itself took {:.2f} s ({:.2f} %)\n",
             end.done, app::timeText(end.wall_s), end.runs_cpu_s, end.own_cpu_s,
             end.runs_cpu_s > 0 ? 100 * end.own_cpu_s / end.runs_cpu_s : 0);
}

/// What is finished is in the folder, whatever went wrong: a full disk, a program that changed.
batch::ScheduleEnd doAll(const Store& store, const Plan& plan,
                         const batch::ScheduleOptions& options) {
  try {
    return batch::doRuns(store, plan, options);
  } catch (const core::UsageError&) {
    throw;
  } catch (const core::Error& e) {
    throw core::Error(
        fmt::format("{}\n{}: finished runs are kept; the same command goes on", e.what(), kName));
  }
}

/// Does what is to be done. Returns the exit code.
int work(const Options& o, const Plan& plan, const Store& store, std::ostream& err) {
  const app::Interrupt interrupt;
  RunProgress progress(err, o.quiet);
  batch::ScheduleOptions options;
  options.jobs = o.jobs;
  options.slice = o.slice;
  options.slices = o.slices;
  options.stop = [&] { return interrupt.signal() != 0; };
  options.tell = [&](const batch::ScheduleProgress& p) { progress.tell(p); };
  const batch::ScheduleEnd end = doAll(store, plan, options);
  progress.finish();
  tellEnd(o, end, err);
  if (end.stopped) {
    fmt::print(err, "{}: stopped; finished runs are kept, the same command goes on\n", kName);
    return 128 + interrupt.signal();
  }
  return end.failed == 0 ? 0 : 1;
}

int runExperiment(const Options& o, std::ostream& out, std::ostream& err) {
  const Plan plan = planFor(o);
  const Store store(o.folder.empty() ? "." : o.folder);
  if (o.dry_run) {
    printPlan(plan, o.folder.empty() ? nullptr : &store, o.jobs, out);
    return 0;
  }
  store.writePlan(plan);
  if (o.again_failed) forgetFailed(plan, store);
  const int code = work(o, plan, store, err);
  if (code > 1) return code;
  const auto failed = batch::countRuns(plan, store.results(plan)).failed;
  if (failed > 0)
    fmt::print(err,
               "{}: {} runs failed: see {} status {}; run with --again-failed does them again\n",
               kName, failed, kName, o.folder);
  showResults(o, plan, store, out, err);
  return failed > 0 ? 1 : 0;
}

int run(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  const auto options = parseOptions(args, out);
  if (!options) return 0;
  if (options->command == Command::run) return runExperiment(*options, out, err);
  if (options->command == Command::submit) return submit(*options, out, err);
  const Store store(options->folder);
  const Plan plan = store.readPlan();
  if (options->command == Command::work) return work(*options, plan, store, err);
  if (options->command == Command::collect) return collect(plan, store, out, err);
  if (options->command == Command::status) {
    printStatus(plan, store, out);
    printClusterStatus(plan, store, out);
  } else {
    showResults(*options, plan, store, out, err);
  }
  return 0;
}

}  // namespace

int runExperimentApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  return app::runProgram(kName, err, [&] { return run(args, out, err); });
}

}  // namespace ariadne
