#include "ariadne/experiment/neff_fall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/io/csv.h"

namespace ariadne::experiment {
std::vector<NeffStep> readNeffSteps(const std::filesystem::path& file) {
  const io::CsvTable table = io::readCsv(file);
  const std::size_t time_s = table.column("time_s");
  const std::size_t neff = table.column("neff");
  const std::size_t resampled = table.column("resampled");
  const std::size_t particles = table.column("particles");
  std::vector<NeffStep> steps;
  for (std::size_t i = 0; i < table.size(); ++i) {
    steps.push_back({table.number(i, time_s), table.number(i, neff),
                     table.number(i, resampled) != 0, table.number(i, particles)});
    if (steps.back().neff <= 0 || steps.back().particles <= 0)
      throw core::Error(fmt::format("{}: Neff {} of {} particles", table.place(i),
                                    steps.back().neff, steps.back().particles));
  }
  return steps;
}

std::vector<NeffChange> neffChanges(const std::vector<NeffStep>& steps,
                                    const std::vector<eval::PathPoint>& truth) {
  std::vector<NeffChange> changes;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const NeffStep& before = steps[i - 1];
    const eval::PathPoint& here = eval::pointAt(truth, steps[i].time_s);
    const double from = before.resampled ? before.particles : before.neff;
    changes.push_back({here.travelled_m,
                       here.travelled_m - eval::pointAt(truth, before.time_s).travelled_m,
                       here.passes, std::log(steps[i].neff / from), steps[i].resampled});
  }
  return changes;
}

std::array<NeffFall, 4> neffFall(const std::vector<NeffChange>& changes) {
  std::array<NeffFall, 4> sums{};
  for (const NeffChange& c : changes) {
    NeffFall& sum = sums[std::min<std::size_t>(c.passes, sums.size() - 1)];
    sum.travelled_m += c.length_m;
    sum.ln_change += c.ln_change;
    sum.resamplings += c.resampled ? 1 : 0;
  }
  return sums;
}

}  // namespace ariadne::experiment
