#include "ariadne/batch/runs_csv.h"

#include <fmt/format.h>

#include "ariadne/batch/text_table.h"
#include "cell_pairs.h"

namespace ariadne::batch {
namespace {

const char* wordOf(Judgement judgement) {
  if (judgement == Judgement::unjudged) return "unjudged";
  return judgement == Judgement::success ? "1" : "0";
}

std::vector<std::string> rowOf(const Plan& plan, const PlannedRun& run, const RunResult& result) {
  std::vector<std::string> row = {std::to_string(run.seed)};
  row.insert(row.end(), run.values.begin(), run.values.end());
  row.push_back(plan.arms[run.arm].name);
  const bool finished = isFinished(&result);
  row.emplace_back(finished ? "0" : "1");
  if (!plan.success.figure.empty())
    row.emplace_back(finished ? wordOf(successOf(plan, run.arm).of(result.figures)) : "");
  for (const std::string& figure : plan.figures) {
    const auto value = valueOf(result.figures, plan.arms[run.arm].prefix + figure);
    row.push_back(value ? fmt::format("{}", *value) : "");
  }
  return row;
}

}  // namespace

std::string runsCsv(const Plan& plan, const std::map<std::string, RunResult>& results) {
  TextTable table;
  table.header = {"seed"};
  table.header.insert(table.header.end(), plan.factors.begin(), plan.factors.end());
  table.header.insert(table.header.end(), {"arm", "failed"});
  if (!plan.success.figure.empty()) table.header.emplace_back("success");
  table.header.insert(table.header.end(), plan.figures.begin(), plan.figures.end());
  for (const PlannedRun& run : plan.runs) {
    const auto result = results.find(run.key);
    if (result != results.end()) table.rows.push_back(rowOf(plan, run, result->second));
  }
  return render(table, TableFormat::csv);
}

}  // namespace ariadne::batch
