// The cells of an experiment as a table: which columns there are, and how each is written.
#include <fmt/format.h>

#include <algorithm>

#include "ariadne/batch/tables.h"
#include "ariadne/statistics/interval.h"
#include "figure_columns.h"

namespace ariadne::batch {
namespace {

using Columns = std::vector<Column>;

double rateOf(const Cell& c) {
  return static_cast<double>(c.successes) / static_cast<double>(c.judged());
}

/// Of no run nothing is known.
statistics::Interval intervalOf(const Cell& c) {
  return c.judged() > 0 ? statistics::wilsonInterval(c.successes, c.judged())
                        : statistics::Interval{0, 1};
}

void addRates(Columns& columns, bool csv) {
  if (csv) {
    columns.push_back({"successes", [](const Cell& c) { return std::to_string(c.successes); }});
    columns.push_back({"rate", [](const Cell& c) {
                         return c.judged() > 0 ? fmt::format("{:.6f}", rateOf(c)) : "";
                       }});
    columns.push_back(
        {"rate_low", [](const Cell& c) { return fmt::format("{:.6f}", intervalOf(c).low); }});
    columns.push_back(
        {"rate_high", [](const Cell& c) { return fmt::format("{:.6f}", intervalOf(c).high); }});
    return;
  }
  columns.push_back({"success", [](const Cell& c) {
                       return c.judged() == 0 ? "0/0"
                                              : fmt::format("{}/{} ({:.0f} %)", c.successes,
                                                            c.judged(), 100 * rateOf(c));
                     }});
  columns.push_back({"95 % interval", [](const Cell& c) {
                       const auto i = intervalOf(c);
                       const int decimals = c.judged() < 200 ? 0 : 1;
                       return fmt::format("{:.{}f}-{:.{}f} %", 100 * i.low, decimals, 100 * i.high,
                                          decimals);
                     }});
}

Column ofPairs(const std::string& name, std::function<std::string(const Pairs&)> text) {
  return {name, [text = std::move(text)](const Cell& c) { return c.pairs ? text(*c.pairs) : ""; }};
}

void addPairs(Columns& columns, bool csv) {
  if (csv) {
    columns.push_back(
        ofPairs("only_first", [](const Pairs& p) { return std::to_string(p.only_first); }));
    columns.push_back(
        ofPairs("only_this", [](const Pairs& p) { return std::to_string(p.only_this); }));
  } else {
    columns.push_back(ofPairs("only first / only this", [](const Pairs& p) {
      return fmt::format("{} / {}", p.only_first, p.only_this);
    }));
  }
  const char* digits = csv ? "{:.6g}" : "{:.2g}";
  columns.push_back(
      ofPairs("p", [digits](const Pairs& p) { return fmt::format(fmt::runtime(digits), p.p); }));
  columns.push_back(ofPairs(csv ? "p_holm" : "p (Holm)", [digits](const Pairs& p) {
    return fmt::format(fmt::runtime(digits), p.p_holm);
  }));
}

/// Most experiments judge all their runs: their tables have no column of zeros.
bool anyUnjudged(const std::vector<Cell>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](const Cell& c) { return c.unjudged > 0; });
}

Columns columnsOf(const Plan& plan, const std::vector<Cell>& cells, bool csv) {
  Columns columns;
  for (std::size_t i = 0; i < plan.factors.size(); ++i)
    columns.push_back({plan.factors[i], [i](const Cell& c) { return c.values[i]; }});
  columns.push_back({"arm", [&plan](const Cell& c) { return plan.arms[c.arm].name; }});
  columns.push_back({"runs", [](const Cell& c) { return std::to_string(c.finished); }});
  columns.push_back({"failed", [](const Cell& c) { return std::to_string(c.failed); }});
  if (anyUnjudged(cells))
    columns.push_back({"unjudged", [](const Cell& c) { return std::to_string(c.unjudged); }});
  if (!plan.success.figure.empty()) addRates(columns, csv);
  addFigures(columns, plan, csv);
  if (!plan.success.figure.empty() && plan.arms.size() > 1) addPairs(columns, csv);
  return columns;
}

std::vector<std::string> notesOf(const Plan& plan, const std::vector<Cell>& cells) {
  std::vector<std::string> notes;
  if (!plan.success.figure.empty())
    notes.push_back(
        fmt::format("Success: {}; Wilson's interval. Failed runs (crashed, killed, over "
                    "their time) count in no other column.",
                    plan.success.text()));
  if (anyUnjudged(cells))
    notes.push_back(
        fmt::format("Unjudged: the program says that there was nothing to judge {} by. Such runs "
                    "are in no rate and no p.",
                    plan.success.figure));
  if (!plan.success.figure.empty() && plan.arms.size() > 1)
    notes.push_back(fmt::format(
        "p: McNemar's exact test on the seeds that {} and the arm have both finished; Holm: "
        "adjusted for all of this table.",
        plan.arms[0].name));
  if (!plan.figures.empty())
    notes.emplace_back(
        "Figures are medians of the runs that have them, with the bootstrap's 95 % interval (under "
        "ten runs it covers less).");
  if (!plan.relative.empty() && plan.arms.size() > 1)
    notes.push_back(
        fmt::format("Against {}: median of the changes seed by seed, likewise with its interval.",
                    plan.arms[0].name));
  return notes;
}

}  // namespace

TextTable tableOf(const Plan& plan, const std::vector<Cell>& cells, TableFormat format) {
  TextTable table;
  table.title = plan.title;
  const Columns columns = columnsOf(plan, cells, format == TableFormat::csv);
  for (const Column& column : columns) table.header.push_back(column.name);
  for (const Cell& cell : cells) {
    table.rows.emplace_back();
    for (const Column& column : columns) table.rows.back().push_back(column.text(cell));
  }
  table.notes = notesOf(plan, cells);
  return table;
}

}  // namespace ariadne::batch
