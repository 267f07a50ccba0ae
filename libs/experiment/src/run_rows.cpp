#include "ariadne/experiment/run_rows.h"

#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <sstream>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::experiment {
namespace {

/// A column: its name, and a number of a run or nothing.
struct Column {
  const char* name;
  std::function<double(const LoopRunResult&)> get;
  std::function<void(LoopRunResult&, double)> set;
};

#define ARIADNE_COLUMN(name, member)                                                      \
  Column {                                                                                \
    name, [](const LoopRunResult& r) { return static_cast<double>(r.member); },           \
        [](LoopRunResult& r, double v) { r.member = static_cast<decltype(r.member)>(v); } \
  }
#define ARIADNE_INNER(name, member)                                                    \
  Column {                                                                             \
    name, [](const LoopRunResult& r) { return static_cast<double>(r.inner->member); }, \
        [](LoopRunResult& r, double v) {                                               \
          r.inner->member = static_cast<decltype(r.inner->member)>(v);                 \
        }                                                                              \
  }

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      ARIADNE_COLUMN("recovered_exists", recovered.exists),
      ARIADNE_COLUMN("recovered_chosen", recovered.chosen),
      ARIADNE_COLUMN("recovered_correct_weight", recovered.correct_weight),
      ARIADNE_COLUMN("recovered_translation_m", recovered.worst_translation_m),
      ARIADNE_COLUMN("recovered_heading_deg", recovered.worst_heading_deg),
      ARIADNE_COLUMN("recovered_best_translation_m", recovered.best_translation_m),
      ARIADNE_COLUMN("recovered_ate_m", recovered.ate_m),
      ARIADNE_COLUMN("standard_exists", standard.exists),
      ARIADNE_COLUMN("standard_chosen", standard.chosen),
      ARIADNE_COLUMN("standard_correct_weight", standard.correct_weight),
      ARIADNE_COLUMN("standard_translation_m", standard.worst_translation_m),
      ARIADNE_COLUMN("standard_heading_deg", standard.worst_heading_deg),
      ARIADNE_COLUMN("standard_best_translation_m", standard.best_translation_m),
      ARIADNE_COLUMN("standard_ate_m", standard.ate_m),
      ARIADNE_COLUMN("closings", closings),
      ARIADNE_COLUMN("recoveries", recoveries)};
  return all;
}

const std::vector<Column>& innerColumns() {
  static const std::vector<Column> all = {ARIADNE_INNER("existed_error_m", existed_error_m),
                                          ARIADNE_INNER("saved_error_m", saved_error_m),
                                          ARIADNE_INNER("left_error_m", left_error_m),
                                          ARIADNE_INNER("survivors", survivors),
                                          ARIADNE_INNER("distinct_left", distinct_left),
                                          ARIADNE_INNER("distinct_saved", distinct_saved),
                                          ARIADNE_INNER("kl_saved_nats", kl_saved_nats),
                                          ARIADNE_INNER("kl_left_nats", kl_left_nats),
                                          ARIADNE_INNER("lost_mass", lost_mass),
                                          ARIADNE_INNER("neff_slope_per_m", neff_slope_per_m),
                                          ARIADNE_INNER("resamplings", resamplings)};
  return all;
}
#undef ARIADNE_COLUMN
#undef ARIADNE_INNER

std::string header() {
  std::string line = "name,laps,seed";
  for (const Column& c : columns()) line += fmt::format(",{}", c.name);
  for (const Column& c : innerColumns()) line += fmt::format(",{}", c.name);
  return line;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

LoopRow rowOf(const std::string& line, const std::string& place) {
  const auto cells = cellsOf(line);
  if (cells.size() != 3 + columns().size() + innerColumns().size())
    throw core::Error(fmt::format("{}: {} cells; a row has {}", place, cells.size(),
                                  3 + columns().size() + innerColumns().size()));
  const auto number = [&](std::size_t i) {
    char* end = nullptr;
    const double v = std::strtod(cells[i].c_str(), &end);
    if (cells[i].empty() || *end != '\0')
      throw core::Error(fmt::format("{}: \"{}\" is no number", place, cells[i]));
    return v;
  };
  LoopRow row;
  row.name = cells[0];
  row.laps = static_cast<int>(number(1));
  row.seed = static_cast<std::uint64_t>(number(2));
  std::size_t i = 3;
  for (const Column& c : columns()) c.set(row.result, number(i++));
  if (cells[i].empty()) return row;  // nothing was recovered
  row.result.inner.emplace();
  for (const Column& c : innerColumns()) c.set(row.result, number(i++));
  return row;
}

}  // namespace

std::string toCsv(const std::vector<LoopRow>& rows) {
  std::string out = header() + "\n";
  for (const LoopRow& row : rows) {
    out += fmt::format("{},{},{}", row.name, row.laps, row.seed);
    for (const Column& c : columns()) out += fmt::format(",{}", c.get(row.result));
    for (const Column& c : innerColumns())
      out += row.result.inner ? fmt::format(",{}", c.get(row.result)) : ",";
    out += "\n";
  }
  return out;
}

std::vector<LoopRow> readRows(const std::filesystem::path& file) {
  std::istringstream in(io::readWhole(file));
  std::string line;
  if (!std::getline(in, line) || line != header())
    throw core::Error(file.string() + ":1: is no file of this experiment's rows");
  std::vector<LoopRow> rows;
  for (int number = 2; std::getline(in, line); ++number)
    rows.push_back(rowOf(line, fmt::format("{}:{}", file.string(), number)));
  return rows;
}

}  // namespace ariadne::experiment
