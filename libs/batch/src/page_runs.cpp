#include "page_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "ariadne/page/html.h"
#include "ariadne/page/parts.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::size_t kMostFailed = 1000000;
constexpr std::size_t kMostRunsShown = 3500000;

Words headerOf(const Plan& plan) {
  Words header = {"seed", "result"};
  header.insert(header.end(), plan.figures.begin(), plan.figures.end());
  header.insert(header.end(), {"wall clock (s)", "files"});
  return header;
}

std::string resultOf(const Outcome& o, const PlannedRun& run, const RunResult* result) {
  if (!result) return "missing";
  if (!result->failure.empty()) return "failed: " + result->failure;
  if (o.plan.success.figure.empty()) return "finished";
  Success success = o.plan.success;
  success.figure = o.plan.arms[run.arm].prefix + success.figure;
  const Judgement judgement = success.of(result->figures);
  if (judgement == Judgement::unjudged) return "unjudged";
  return judgement == Judgement::success ? "success" : "no success";
}

/// Links to what is there; `%` and the like do not come in keys, which are hashes.
std::string linksOf(const PlannedRun& run, const RunResult* result, const Store& store) {
  std::string links;
  const auto add = [&](const std::string& file, const char* text) {
    links += fmt::format("{}<a href=\"{}\">{}</a>", links.empty() ? "" : " ", file, text);
  };
  std::error_code ignored;
  const std::string key = page::escapedHtml(run.key);
  if (fs::exists(store.files(run.key) / "report.html", ignored))
    add("files/" + key + "/report.html", "report");
  else if (fs::exists(store.files(run.key), ignored))
    add("files/" + key + "/", "files");
  if (result) add("runs/" + key + ".json", "all figures");
  return links;
}

std::string rowOf(const Outcome& o, const PlannedRun& run, const Store& store) {
  const auto found = o.results.find(run.key);
  const RunResult* result = found == o.results.end() ? nullptr : &found->second;
  Words row = {std::to_string(run.seed), page::escapedHtml(resultOf(o, run, result))};
  for (const std::string& figure : o.plan.figures) {
    row.emplace_back();
    if (!result) continue;
    if (const auto value = valueOf(result->figures, o.plan.arms[run.arm].prefix + figure))
      row.back() = fmt::format("{:.6g}", *value);
  }
  row.push_back(result ? fmt::format("{:.1f}", result->wall_s) : "");
  row.push_back(linksOf(run, result, store));
  return page::htmlRow(row);
}

/// "laps 10, frontier".
std::string nameOf(const Plan& plan, const Cell& cell) {
  std::string name;
  for (std::size_t i = 0; i < plan.factors.size(); ++i)
    name += plan.factors[i] + " " + cell.values[i] + ", ";
  return name + plan.arms[cell.arm].name;
}

}  // namespace

std::string failedHtml(const Outcome& o) {
  page::BoundedList list(kMostFailed);
  std::set<std::string> told;
  for (const PlannedRun& run : o.plan.runs) {
    const auto r = o.results.find(run.key);
    if (r == o.results.end() || r->second.failure.empty() || !told.insert(run.key).second) continue;
    const std::string name = describe(o.plan, run);
    list.add(fmt::format("<h3>{}</h3>\n<p>{}</p>\n", page::escapedHtml(name),
                         page::escapedHtml(r->second.failure)) +
             (r->second.last_words.empty()
                  ? ""
                  : page::htmlListing("Last words of " + name, r->second.last_words)));
  }
  if (told.empty()) return "<p>None.</p>\n";
  return list.html() +
         page::leftOutHtml(list.leftOut(), "failed runs", "ariadne-experiment status");
}

std::string runsHtml(const Outcome& o, const Store& store) {
  std::map<std::pair<Words, std::size_t>, std::vector<const PlannedRun*>> groups;
  for (const PlannedRun& run : o.plan.runs) groups[{run.values, run.arm}].push_back(&run);
  std::string text;
  std::size_t left = kMostRunsShown;
  std::size_t left_out = 0;
  for (const Cell& cell : o.cells) {
    std::string rows;
    for (const PlannedRun* run : groups[{cell.values, cell.arm}]) {
      if (rows.size() < left)
        rows += rowOf(o, *run, store);
      else
        ++left_out;
    }
    if (rows.empty()) continue;
    const std::string name = nameOf(o.plan, cell);
    text += page::htmlDetails(fmt::format("{}: {} of {} finished, {} failed", name, cell.finished,
                                          cell.planned, cell.failed),
                              page::htmlTable("Runs of " + name, headerOf(o.plan), rows));
    left = kMostRunsShown - std::min(text.size(), kMostRunsShown);
  }
  return text + page::leftOutHtml(left_out, "runs", "the folder runs");
}

}  // namespace ariadne::batch
