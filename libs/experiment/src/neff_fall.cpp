#include "ariadne/experiment/neff_fall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::experiment {
namespace {

// What ariadne-slam puts first on a line.
constexpr const char* kColumns = "step,time_s,neff,resampled,particles,";

NeffStep stepOf(const std::string& line, const std::string& place) {
  std::istringstream in(line);
  std::array<double, 5> v{};
  for (double& number : v) {
    std::string cell;
    std::getline(in, cell, ',');
    char* end = nullptr;
    number = std::strtod(cell.c_str(), &end);
    if (cell.empty() || *end != '\0' || !std::isfinite(number))
      throw core::Error(fmt::format("{}: \"{}\" is no number", place, cell));
  }
  if (v[2] <= 0 || v[4] <= 0)
    throw core::Error(fmt::format("{}: Neff {} of {} particles", place, v[2], v[4]));
  return {v[1], v[2], v[3] != 0, v[4]};
}

}  // namespace

std::vector<NeffStep> readNeffSteps(const std::filesystem::path& file) {
  std::istringstream in(io::readText(file));
  std::string line;
  if (!std::getline(in, line) || line.rfind(kColumns, 0) != 0)
    throw core::Error(file.string() + ":1: is no steps.csv of ariadne-slam");
  std::vector<NeffStep> steps;
  for (int number = 2; std::getline(in, line); ++number)
    steps.push_back(stepOf(line, fmt::format("{}:{}", file.string(), number)));
  return steps;
}

std::vector<NeffChange> neffChanges(const std::vector<NeffStep>& steps,
                                    const std::vector<eval::PathPoint>& truth) {
  std::vector<NeffChange> changes;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const NeffStep& before = steps[i - 1];
    const eval::PathPoint& here = eval::pointAt(truth, steps[i].time_s);
    const double from = before.resampled ? before.particles : before.neff;
    changes.push_back({here.way_m, here.way_m - eval::pointAt(truth, before.time_s).way_m,
                       here.passes, std::log(steps[i].neff / from), steps[i].resampled});
  }
  return changes;
}

std::array<NeffFall, 4> neffFall(const std::vector<NeffChange>& changes) {
  std::array<NeffFall, 4> sums{};
  for (const NeffChange& c : changes) {
    NeffFall& sum = sums[std::min<std::size_t>(c.passes, sums.size() - 1)];
    sum.way_m += c.length_m;
    sum.ln_change += c.ln_change;
    sum.resamplings += c.resampled ? 1 : 0;
  }
  return sums;
}

}  // namespace ariadne::experiment
