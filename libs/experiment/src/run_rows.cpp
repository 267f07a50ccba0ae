#include "ariadne/experiment/run_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>
#include <type_traits>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::experiment {
namespace {

/// A column: its name, and a number of a run or nothing.
struct Column {
  const char* name;
  std::function<double(const LoopRunResult&)> get;
  std::function<bool(LoopRunResult&, double)> set;  ///< false: no number of this column
};

/// False for what a flag or count cannot be; a double counts up to 2^53.
template <class T>
bool setTo(T& member, double v) {
  const double most =
      std::min(9007199254740992.0, static_cast<double>(std::numeric_limits<T>::max()));
  if (std::is_integral_v<T> && !(v >= 0 && v <= most && v == std::floor(v))) return false;
  member = static_cast<T>(v);
  return true;
}

#define ARIADNE_COLUMN(name, member)                                            \
  Column {                                                                      \
    name, [](const LoopRunResult& r) { return static_cast<double>(r.member); }, \
        [](LoopRunResult& r, double v) { return setTo(r.member, v); }           \
  }
#define ARIADNE_INNER(name, member)                                                    \
  Column {                                                                             \
    name, [](const LoopRunResult& r) { return static_cast<double>(r.inner->member); }, \
        [](LoopRunResult& r, double v) { return setTo(r.inner->member, v); }           \
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
  const auto expect = [&](bool fits, const char* column, std::size_t i) {
    if (!fits)
      throw core::Error(fmt::format("{}: {} is \"{}\"; it takes a whole number from 0, or 0 and 1",
                                    place, column, cells[i]));
  };
  expect(setTo(row.laps, number(1)), "laps", 1);
  expect(setTo(row.seed, number(2)), "seed", 2);
  std::size_t i = 3;
  for (const Column& c : columns()) expect(c.set(row.result, number(i)), c.name, i), ++i;
  if (cells[i].empty()) return row;  // nothing was recovered
  row.result.inner.emplace();
  for (const Column& c : innerColumns()) {
    if (i >= count) break;
    expect(c.set(row.result, number(i)), c.name, i);
    ++i;
  }
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
  std::istringstream in(io::readText(file));
  std::string line;
  const std::size_t count = std::getline(in, line) ? cellsOfHeader(line) : 0;
  if (count == 0) throw core::Error(file.string() + ":1: is no file of this experiment's rows");
  std::vector<LoopRow> rows;
  for (int number = 2; std::getline(in, line); ++number)
    rows.push_back(rowOf(line, count, fmt::format("{}:{}", file.string(), number)));
  return rows;
}

}  // namespace ariadne::experiment
