#include "ariadne/batch/experiment_page.h"
#include "ariadne/batch/figures.h"
#include "ariadne/batch/run_counts.h"
#include "ariadne/batch/store.h"
#include "ariadne/batch/tables.h"
#include "ariadne/cluster/parallel_command.h"
#include "ariadne/cluster/slices.h"
#include "ariadne/cluster/submission.h"
#include "ariadne/experiment/neff_fall.h"
#include "ariadne/io/csv.h"
#include "ariadne/io/whole_file.h"
#include "parts.h"

namespace ariadne::fuzz {
namespace {

/// What `table`, `status` and `report` make of a plan and results.
void showAll(const batch::Plan& plan, const std::map<std::string, batch::RunResult>& results) {
  const auto cells = batch::cellsOf(plan, results);
  for (const auto format : {batch::TableFormat::text, batch::TableFormat::csv,
                            batch::TableFormat::markdown, batch::TableFormat::latex})
    batch::render(batch::tableOf(plan, cells, format), format);
  batch::plotsOf(plan, cells);
  batch::countRuns(plan, results);
  for (const auto& run : plan.runs) batch::describe(plan, run);
}

}  // namespace

/// Every run has the same result.
void readPlan(const Path& file) {
  const batch::Store store(file.parent_path());
  const batch::Plan plan = store.readPlan();
  std::map<std::string, batch::RunResult> results;
  for (const auto& run : plan.runs) {
    auto& r = results[run.key];
    for (const auto& figure : plan.figures) r.figures[figure] = 1;
    r.figures[plan.success.figure] = 1;
  }
  cluster::openSlices(plan, store, 3, {{1, 3}});
  showAll(plan, results);
}

void readResult(const Path& file) {
  const auto result = batch::parseResult(io::readWhole(file), file.string());
  batch::Plan plan;
  plan.arms.resize(1);
  plan.figures = {"value"};
  plan.success = {"ok", "!=", 0};
  plan.runs.resize(1);
  plan.runs[0].key = result.key;
  showAll(plan, {{result.key, result}});
}

void readJob(const Path& file) {
  const Path jobs = file.parent_path() / "jobs" / "1";
  std::filesystem::create_directories(jobs);
  std::filesystem::copy_file(file, jobs / "job.json",
                             std::filesystem::copy_options::overwrite_existing);
  cluster::Submissions(file.parent_path()).all();
}

void readJoblog(const Path& file) { cluster::readJoblog(file); }

void readSteps(const Path& file) { experiment::readNeffSteps(file); }

/// What a run's program left.
void readFigures(const Path& file) { batch::figuresOfSummary(io::readWhole(file), "in.txt"); }

void readCsv(const Path& file) {
  const io::CsvTable table = io::readCsv(file);
  for (std::size_t i = 0; i < table.size(); ++i) table.number(i, table.column("x"));
}

}  // namespace ariadne::fuzz
