#include "neff_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/charts/curves.h"
#include "ariadne/core/error.h"
#include "ariadne/experiment/neff_fall.h"
#include "ariadne/io/tum.h"
#include "ariadne/statistics/interval.h"

namespace ariadne::eval_app {
namespace {

using experiment::NeffChange;
using experiment::NeffFall;
using Runs = std::vector<std::vector<NeffChange>>;

constexpr double kUnit_m = 10;  // figures are per this distance

Runs readRuns(const std::vector<std::string>& files, const std::vector<eval::PathPoint>& truth) {
  Runs runs;
  for (const std::string& file : files) {
    runs.push_back(experiment::neffChanges(experiment::readNeffSteps(file), truth));
    if (runs.back().empty() || runs.back().back().travelled_m <= 0)
      throw core::Error(file + " has no two updates within the time of the truth");
  }
  return runs;
}

/// Fall since the start at each metre, mean of the runs.
charts::Curve fallOf(const std::string& name, const Runs& runs, double length_m) {
  std::vector<double> fall(static_cast<std::size_t>(length_m) + 2, 0.0);
  for (const auto& run : runs)
    for (const NeffChange& c : run)
      fall[static_cast<std::size_t>(std::ceil(c.travelled_m))] -=
          c.ln_change / static_cast<double>(runs.size());
  charts::Curve curve{name, {}, {}};
  double sum = 0;
  for (std::size_t m = 0; m < fall.size(); ++m) {
    sum += fall[m];
    curve.x.push_back(static_cast<double>(m));
    curve.y.push_back(sum);
  }
  return curve;
}

/// Grey where the path was before, darker with each pass.
std::vector<charts::Band> bandsOf(const std::vector<eval::PathPoint>& truth) {
  std::vector<charts::Band> bands;
  std::size_t passes = 0;
  for (const eval::PathPoint& p : truth) {
    if (p.passes > 0 && p.passes == passes)
      bands.back().x1 = p.travelled_m;
    else if (p.passes > 0)
      bands.push_back(
          {p.travelled_m, p.travelled_m, std::max(0.6, 1 - 0.1 * static_cast<double>(p.passes))});
    passes = p.passes;
  }
  return bands;
}

/// Median of the runs' values with its 95 % interval.
std::string medianOf(std::vector<double> values) {
  core::RandomStream rng(1, 0, 0, core::Purpose::resampling);
  const statistics::Interval interval = statistics::medianInterval(values, rng);
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  const double median = (values[(n - 1) / 2] + values[n / 2]) / 2;
  return fmt::format("{:.2f} [{:.2f} to {:.2f}]", median, interval.low, interval.high);
}

struct Stretch {
  const char* name;
  std::size_t from;  ///< passes, both ends included
  std::size_t to;
};

NeffFall sumOf(const std::vector<NeffChange>& run, const Stretch& s) {
  const auto by_passes = experiment::neffFall(run);
  NeffFall sum;
  for (std::size_t i = s.from; i <= s.to; ++i) {
    sum.travelled_m += by_passes[i].travelled_m;
    sum.ln_change += by_passes[i].ln_change;
    sum.resamplings += by_passes[i].resamplings;
  }
  return sum;
}

/// A row of the table; nothing where no run went there.
std::string rowOf(const Stretch& s, const char* weights, const Runs& runs) {
  std::vector<double> change;
  std::vector<double> resamplings;
  double travelled_m = 0;
  for (const auto& run : runs) {
    const NeffFall sum = sumOf(run, s);
    if (sum.travelled_m <= 0) continue;
    travelled_m += sum.travelled_m / static_cast<double>(runs.size());
    change.push_back(kUnit_m * sum.ln_change / sum.travelled_m);
    resamplings.push_back(kUnit_m * static_cast<double>(sum.resamplings) / sum.travelled_m);
  }
  if (change.empty()) return "";
  return fmt::format("| {} | {:.0f} | {} | {} | {} |\n", s.name, travelled_m, weights,
                     medianOf(std::move(change)), medianOf(std::move(resamplings)));
}

}  // namespace

std::string neffOfLog(const std::filesystem::path& png, const std::filesystem::path& truth_file,
                      const std::vector<std::string>& plain,
                      const std::vector<std::string>& revisit) {
  const auto truth = eval::pathPasses(io::readTum(truth_file));
  const Runs plain_runs = readRuns(plain, truth);
  const Runs revisit_runs = readRuns(revisit, truth);
  const double length_m = truth.back().travelled_m;
  charts::writeCurves(png, {"Fall of ln Neff, resampling taken out",
                            "distance, m (grey: driven before, the darker the more often)",
                            "nats",
                            {fallOf("plain weights", plain_runs, length_m),
                             fallOf("1/r^2 at the r-th revisit", revisit_runs, length_m)},
                            {},
                            bandsOf(truth)});
  std::string table =
      "| passed before | distance, m | weights | change of ln Neff per 10 m | resamplings per 10 m "
      "|\n"
      "|---|---|---|---|---|\n";
  for (const Stretch& s : {Stretch{"never", 0, 0}, Stretch{"ever", 1, 3}, Stretch{"once", 1, 1},
                           Stretch{"twice", 2, 2}, Stretch{"more often", 3, 3}}) {
    table += rowOf(s, "plain", plain_runs);
    table += rowOf(s, "revisit", revisit_runs);
  }
  return table;
}

}  // namespace ariadne::eval_app
