#include "ariadne/batch/figures.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ariadne/core/error.h"
#include "ariadne/eval/errors.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::batch {
namespace {

using PlainJson = nlohmann::json;

void collect(const PlainJson& at, const std::string& name, int depth, Figures& figures) {
  if (depth > 100) throw core::Error("the JSON is nested deeper than 100");  // the stack has an end
  if (at.is_boolean())
    figures[name] = at.get<bool>() ? 1 : 0;
  else if (at.is_number() && std::isfinite(at.get<double>()))
    figures[name] = at.get<double>();
  else if (at.is_object())
    for (const auto& [key, value] : at.items())
      if (key != "parameters")
        collect(value, name.empty() ? key : name + "." + key, depth + 1, figures);
}

std::vector<std::string> cellsOf(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Of poses at most this far apart in time one is interpolated, as ariadne-slam --truth does.
constexpr double kTruthGap_s = 1;

double ateOf(const std::filesystem::path& trajectory, const std::string& truth) {
  const auto pairs = eval::associate(io::readTum(trajectory), io::readTum(truth), kTruthGap_s);
  if (pairs.empty())
    throw core::Error(fmt::format("no pose of the trajectory has the time of one of {}", truth));
  return eval::figuresOf(eval::absoluteErrors(pairs, eval::align(pairs))).rmse;
}

}  // namespace

Figures figuresOfSummary(const std::string& text, const std::string& name) {
  try {
    Figures figures;
    collect(PlainJson::parse(text), "", 0, figures);
    return figures;
  } catch (const PlainJson::exception& e) {
    throw core::Error(fmt::format("{} is no JSON: {}", name, e.what()));
  }
}

Figures figuresOfRow(const std::string& csv, const std::string& name) {
  std::istringstream lines(csv);
  std::string header;
  std::string row;
  if (!std::getline(lines, header) || !std::getline(lines, row) || row.empty())
    throw core::Error(fmt::format("{} holds no row", name));
  const auto names = cellsOf(header);
  const auto cells = cellsOf(row);
  Figures figures;
  for (std::size_t i = 0; i < cells.size() && i < names.size(); ++i) {
    double value = 0;
    const char* end = cells[i].data() + cells[i].size();
    const auto read = std::from_chars(cells[i].data(), end, value);
    if (read.ec == std::errc() && read.ptr == end && std::isfinite(value))
      figures[names[i]] = value;
  }
  return figures;
}

Figures figuresOfStock(const std::string& printed, const std::string& name) {
  double scans = 0;
  double frames = 0;
  double cpu_s = 0;
  double memory_mb = 0;
  if (std::sscanf(printed.c_str(),
                  "scans %lf, frames in the map %lf, CPU user+system %lf s, peak memory %lf MB",
                  &scans, &frames, &cpu_s, &memory_mb) != 4)
    throw core::Error(fmt::format("{} is not what ariadne-stock-rbpf prints", name));
  return {{"dataset.scans", scans},
          {"frames", frames},
          {"costs.cpu_s", cpu_s},
          {"costs.peak_memory_mb", memory_mb}};
}

Figures figuresOf(const PlannedArm& arm, const std::filesystem::path& out) {
  Figures figures;
  if (arm.program.kind == ProgramKind::loops)
    figures = figuresOfRow(io::readText(out / "rows.csv"), "rows.csv");
  else if (arm.program.kind == ProgramKind::stock)
    figures = figuresOfStock(io::readWhole(out / kPrintedFile), kPrintedFile);
  else
    figures = figuresOfSummary(io::readWhole(out / "summary.json"), "summary.json");
  if (!arm.truth.empty()) figures["ate_rmse_m"] = ateOf(out / "trajectory.tum", arm.truth);
  return figures;
}

}  // namespace ariadne::batch
