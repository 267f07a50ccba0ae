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
  static const std::vector<Column> all = {
      ARIADNE_INNER("existed_error_m", existed_error_m),
      ARIADNE_INNER("saved_error_m", saved_error_m),
      ARIADNE_INNER("left_error_m", left_error_m),
      ARIADNE_INNER("survivors", survivors),
      ARIADNE_INNER("distinct_left", distinct_left),
      ARIADNE_INNER("distinct_saved", distinct_saved),
      ARIADNE_INNER("kl_saved_nats", kl_saved_nats),
      ARIADNE_INNER("kl_left_nats", kl_left_nats),
      ARIADNE_INNER("lost_mass", lost_mass),
      ARIADNE_INNER("neff_slope_per_m", neff_slope_per_m),
      ARIADNE_INNER("resamplings", resamplings),
      ARIADNE_INNER("recovery_s", recovery_s),
      ARIADNE_INNER("ln_neff_new_per_10m", ln_neff_new_per_10m),
      ARIADNE_INNER("ln_neff_once_per_10m", ln_neff_once_per_10m),
      ARIADNE_INNER("ln_neff_twice_per_10m", ln_neff_twice_per_10m),
      ARIADNE_INNER("ln_neff_more_per_10m", ln_neff_more_per_10m)};
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

/// Cells of a header, 0 when it is none. Rows of earlier versions end after `resamplings`.
std::size_t cellsOfHeader(const std::string& line) {
  const std::string all = header();
  const std::string least = all.substr(0, all.find(",recovery_s"));
  const bool fits = line.size() >= least.size() && (all + ",").rfind(line + ",", 0) == 0;
  return fits ? cellsOf(line).size() : 0;
}

LoopRow rowOf(const std::string& line, std::size_t count, const std::string& place) {
  const auto cells = cellsOf(line);
  if (cells.size() != count)
    throw core::Error(fmt::format("{}: {} cells; a row has {}", place, cells.size(), count));
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
  for (const Column& c : innerColumns())
    if (i < count) c.set(row.result, number(i++));
  return row;
}

}  // namespace

std::string rowsHeader() { return header(); }

std::string toLine(const LoopRow& row) {
  std::string line = fmt::format("{},{},{}", row.name, row.laps, row.seed);
  for (const Column& c : columns()) line += fmt::format(",{}", c.get(row.result));
  for (const Column& c : innerColumns())
    line += row.result.inner ? fmt::format(",{}", c.get(row.result)) : ",";
  return line;
}

std::vector<LoopRow> readRows(const std::filesystem::path& file) {
  std::istringstream in(io::readWhole(file));
  std::string line;
  const std::size_t count = std::getline(in, line) ? cellsOfHeader(line) : 0;
  if (count == 0) throw core::Error(file.string() + ":1: is no file of this experiment's rows");
  std::vector<LoopRow> rows;
  for (int number = 2; std::getline(in, line); ++number)
    rows.push_back(rowOf(line, count, fmt::format("{}:{}", file.string(), number)));
  return rows;
}

}  // namespace ariadne::experiment
