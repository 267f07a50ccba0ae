#include "ariadne/batch/tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/statistics/exact_tests.h"
#include "cell_pairs.h"

namespace ariadne::batch {
namespace {

using Results = std::map<std::string, RunResult>;
using Values = std::vector<std::string>;

Cell cellOf(const Plan& plan, const Values& values, std::size_t arm, std::size_t planned,
            const Runs& runs) {
  Cell cell;
  cell.values = values;
  cell.arm = arm;
  cell.planned = planned;
  const Success success = successOf(plan, arm);
  cell.samples.resize(plan.figures.size());
  for (const auto& [seed, result] : runs) {
    if (!isFinished(result)) {
      ++cell.failed;
      continue;
    }
    ++cell.finished;
    const Judgement judgement = success.of(result->figures);
    cell.successes += judgement == Judgement::success;
    cell.unjudged += judgement == Judgement::unjudged;
    for (std::size_t i = 0; i < plan.figures.size(); ++i)
      if (const auto value = valueOf(result->figures, plan.arms[arm].prefix + plan.figures[i]))
        cell.samples[i].push_back(*value);
  }
  for (const auto& sample : cell.samples) cell.medians.push_back(medianOf(sample));
  return cell;
}

void adjust(std::vector<Cell>& cells) {
  std::vector<double> p;
  for (const Cell& c : cells)
    if (c.pairs) p.push_back(c.pairs->p);
  const auto adjusted = statistics::holmAdjusted(p);
  std::size_t next = 0;
  for (Cell& c : cells)
    if (c.pairs) c.pairs->p_holm = adjusted[next++];
}

/// All figures that finished runs of the arm have, of this name or any.
struct Found {
  bool any_run = false;
  bool has = false;
  std::vector<std::string> names;  ///< of one run
};

Found find(const Plan& plan, const Results& results, std::size_t arm, const std::string& name) {
  Found found;
  for (const PlannedRun& run : plan.runs) {
    const auto r = run.arm == arm ? results.find(run.key) : results.end();
    if (r == results.end() || !isFinished(&r->second)) continue;
    if (!found.any_run)
      for (const auto& [known, value] : r->second.figures) found.names.push_back(known);
    found.any_run = true;
    if ((found.has = r->second.figures.count(name) > 0)) break;
  }
  return found;
}

core::UsageError noSuchFigure(const std::string& name, const Found& found, const std::string& who) {
  return core::UsageError(fmt::format("[figures] {}: no run{} has it; the nearest is {} of {}",
                                      name, who, core::nearestName(name, found.names),
                                      fmt::join(found.names, ", ")));
}

/// A typing error in a figure's name would look like a figure that no run came to. What success is
/// judged by every arm must have; another figure may be of one arm's program only.
void checkFigures(const Plan& plan, const Results& results) {
  for (const std::string& figure : plan.figures) {
    Found last;
    for (std::size_t arm = 0; arm < plan.arms.size() && !last.has; ++arm) {
      Found found = find(plan, results, arm, plan.arms[arm].prefix + figure);
      if (found.any_run && (!last.any_run || found.has)) last = std::move(found);
    }
    if (last.any_run && !last.has) throw noSuchFigure(figure, last, "");
  }
  if (plan.success.figure.empty()) return;
  for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
    const std::string name = plan.arms[arm].prefix + plan.success.figure;
    const Found found = find(plan, results, arm, name);
    if (found.any_run && !found.has)
      throw noSuchFigure(name, found, fmt::format(" of [arm.{}]", plan.arms[arm].name));
  }
}

}  // namespace

std::optional<double> medianOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t m = values.size() / 2;
  return values.size() % 2 == 1 ? values[m] : (values[m - 1] + values[m]) / 2;
}

std::vector<Cell> cellsOf(const Plan& plan, const Results& results) {
  checkFigures(plan, results);
  std::vector<Values> combinations;  // in the plan's order
  std::map<std::pair<Values, std::size_t>, std::pair<std::size_t, Runs>> groups;
  for (const PlannedRun& run : plan.runs) {
    if (run.seed == plan.runs.front().seed && run.arm == 0) combinations.push_back(run.values);
    auto& [planned, runs] = groups[{run.values, run.arm}];
    ++planned;
    if (const auto r = results.find(run.key); r != results.end()) runs[run.seed] = &r->second;
  }
  std::vector<Cell> cells;
  for (const Values& values : combinations)
    for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
      const auto& [planned, runs] = groups[{values, arm}];
      const Runs& first = groups[{values, 0}].second;
      cells.push_back(cellOf(plan, values, arm, planned, runs));
      cells.back().changes.resize(plan.relative.size());
      if (arm == 0) continue;
      cells.back().changes = changesOf(plan, first, runs, arm);
      if (!plan.success.figure.empty()) cells.back().pairs = pairsOf(plan, first, runs, arm);
    }
  adjust(cells);
  return cells;
}

}  // namespace ariadne::batch
