#include "ariadne/batch/experiment_page.h"

#include <fmt/format.h>

#include "ariadne/batch/config_differences.h"
#include "ariadne/batch/run_counts.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/page/head.h"
#include "ariadne/page/html.h"
#include "ariadne/page/parts.h"
#include "page_files.h"
#include "page_plots.h"
#include "page_runs.h"

namespace ariadne::batch {
namespace {

using Configs = std::map<std::string, std::string>;

constexpr std::size_t kMostRows = 500000;
constexpr std::size_t kMostConfigs = 1000000;

std::string factsHtml(const Outcome& o) {
  const Counts counts = countRuns(o.plan, o.results);
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, value);
  };
  add("Runs", std::to_string(counts.planned));
  add("Finished", std::to_string(counts.finished));
  add("Failed", std::to_string(counts.failed));
  add("Missing", std::to_string(counts.missing()));
  add("Seeds", fmt::format("{} to {}", o.plan.runs.front().seed, o.plan.runs.back().seed));
  return text;
}

std::string resultsHtml(const Outcome& o) {
  const TextTable table = tableOf(o.plan, o.cells, TableFormat::text);
  page::BoundedList rows(kMostRows);
  for (const auto& row : table.rows) rows.add(page::textRow(row));
  std::string text = page::htmlTable("Results", table.header, rows.html()) +
                     page::leftOutHtml(rows.leftOut(), "rows", "ariadne-experiment table");
  for (const std::string& note : table.notes)
    text += fmt::format("<p class=\"notes\">{}</p>\n", page::escapedHtml(note));
  return text;
}

std::string differencesHtml(const Plan& plan, const Configs& configs) {
  const auto differences = differencesOf(plan, configs);
  if (differences.empty()) return "<p>In nothing that their INIs tell.</p>\n";
  page::BoundedList rows(kMostRows);
  for (const KeyDifference& d : differences) {
    std::vector<std::string> row = d.values;
    row.insert(row.begin(), d.key);
    rows.add(page::textRow(row));
  }
  std::vector<std::string> header = {"key"};
  for (const PlannedArm& arm : plan.arms) header.push_back(arm.name);
  return "<div class=\"differences\">" +
         page::htmlTable("In what the arms differ", header, rows.html()) + "</div>\n" +
         page::leftOutHtml(rows.leftOut(), "keys", "the folder configs");
}

/// What a run has in common with those of other seeds: "laps 10, frontier".
std::string withoutSeed(const Plan& plan, const PlannedRun& run) {
  const std::string all = describe(plan, run);
  return all.substr(all.find(", ") + 2);
}

std::string configsHtml(const Plan& plan, const Configs& configs) {
  std::vector<std::string> order;
  std::map<std::string, std::string> users;
  for (const PlannedRun& run : plan.runs) {
    if (run.seed != plan.runs.front().seed) break;
    std::string& text = users[run.config];
    if (text.empty()) order.push_back(run.config);
    text += (text.empty() ? "" : "; ") + withoutSeed(plan, run);
  }
  page::BoundedList list(kMostConfigs);
  for (const std::string& hash : order)
    list.add(page::htmlDetails(
        users[hash], page::htmlListing("Resolved INI of " + users[hash], configs.at(hash))));
  return list.html() + page::leftOutHtml(list.leftOut(), "INIs", "the folder configs");
}

std::string iniHtml(const std::string& text) {
  if (text.empty())
    return "<p>It is not in plan.json, which an earlier version made: run notes it.</p>\n";
  page::BoundedList list(kMostRows);
  list.add(page::htmlListing("The experiment's INI", text));
  return list.html() + page::leftOutHtml(list.leftOut(), "listing", "plan.json");
}

Configs configsOf(const Plan& plan, const Store& store) {
  Configs configs;
  for (const PlannedRun& run : plan.runs)
    if (configs.count(run.config) == 0)
      configs[run.config] = io::readWhole(store.config(run.config));
  return configs;
}

}  // namespace

std::string experimentPage(const Outcome& o, const Store& store) {
  const Configs configs = configsOf(o.plan, store);
  return page::filledTemplate(kPageHtml, [&](std::string_view part) -> std::string {
    if (part == "title") return page::escapedHtml(o.plan.title);
    if (part == "head") return page::headHtml(o.plan.title, kPageStyle, page::Scripts::none);
    if (part == "facts") return factsHtml(o);
    if (part == "results") return resultsHtml(o);
    if (part == "plots") return plotsHtml(o.plots, o.pictures);
    if (part == "differences") return differencesHtml(o.plan, configs);
    if (part == "configs") return configsHtml(o.plan, configs);
    if (part == "failed") return failedHtml(o);
    if (part == "runs") return runsHtml(o, store);
    return iniHtml(o.plan.ini);
  });
}

}  // namespace ariadne::batch
