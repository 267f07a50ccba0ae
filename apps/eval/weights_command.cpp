#include "weights_command.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <mutex>

#include "ariadne/core/error.h"
#include "ariadne/core/parallel.h"
#include "ariadne/experiment/drives.h"
#include "ariadne/experiment/loop_config_file.h"
#include "ariadne/experiment/weight_pairs.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/statistics/interval.h"
#include "ariadne/statistics/logistic.h"
#include "command_line.h"
#include "ini_program.h"
#include "progress.h"

namespace ariadne::eval_app {
namespace {

constexpr const char* kAboutWeights =
    "How far the filter's weights are to be believed. Maps drives with a known truth and takes\n"
    "all pairs of particles of each update: k of P(a is nearer the truth than b) =\n"
    "1/(1 + exp(-k x)), where x is the logarithm of a's weight over b's by the scans of a stretch\n"
    "of path. With k = 1 the weights say what they know, under 1 they say too much, with 0 they\n"
    "tell nothing.";

constexpr const char* kWeightsFooter =
    "Examples:\n"
    "  ariadne-eval weights ini/paper/drives/nested_defaults.ini\n"
    "  ariadne-eval weights A.ini B.ini --last 10 --set filter.weight_gain=0.02\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use.";

struct WeightsOptions {
  std::vector<std::string> inis;
  std::uint64_t first = 1;
  std::uint64_t last = 4;
  experiment::PairParams which;
  std::vector<std::string> settings;
};

void declareWeights(CLI::App& program, WeightsOptions& o) {
  program.footer(kWeightsFooter);
  program.add_option("CONFIG", o.inis, "INIs of drives, as ini/paper/drives/*.ini")->required();
  program.add_option("--first", o.first, "first seed of noise and filter")->capture_default_str();
  program.add_option("--last", o.last, "last seed")->capture_default_str();
  program
      .add_option("--least", o.which.least_m,
                  "m by which the errors of two particles differ at the least, to make a pair")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1000.0));
  program
      .add_option("--stretch", o.which.stretch_m,
                  "m of path whose scans' weights are taken together; 0: of one scan")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1000.0));
  program.add_option("--set", o.settings, "section.key=value, over the INIs")
      ->allow_extra_args(false)
      ->take_all();
}

struct Drive {
  experiment::LoopConfig config;
  experiment::Drives drives;
};

std::vector<Drive> drivesOf(const WeightsOptions& o) {
  std::vector<Drive> all;
  for (const std::string& ini : o.inis) {
    const std::string text = io::readIniText(ini);
    app::expectIniOf("ariadne-loop-experiment", ini, text);
    const auto config = experiment::readLoopConfig(ini, text, o.settings);
    all.push_back({config, experiment::Drives(config, std::nullopt)});
  }
  return all;
}

/// Earlier passes: none, one, two, three and more.
constexpr std::array<const char*, 4> kPlaces = {"never", "once", "twice", "more often"};

/// What one run tells of places that were passed so often.
struct Told {
  std::size_t pairs = 0;
  std::size_t right = 0;  ///< the nearer one was the heavier
  double slope = 0;
};
using RunTold = std::array<Told, kPlaces.size()>;

RunTold toldBy(const std::vector<experiment::WeightPair>& pairs) {
  std::array<std::vector<double>, kPlaces.size()> ratios;
  for (const experiment::WeightPair& p : pairs)
    ratios[std::min(p.passes, ratios.size() - 1)].push_back(p.ln_ratio);
  RunTold told;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const auto right =
        std::count_if(ratios[i].begin(), ratios[i].end(), [](double x) { return x > 0; });
    told[i] = {ratios[i].size(), static_cast<std::size_t>(right),
               statistics::logisticSlope(ratios[i])};
  }
  return told;
}

std::vector<RunTold> mapAll(const std::vector<Drive>& drives, const WeightsOptions& o) {
  const std::size_t seeds = o.last - o.first + 1;
  std::vector<RunTold> runs(drives.size() * seeds);
  app::Progress progress(std::cerr, app::progressStyle(false, std::cerr));
  std::mutex mutex;
  std::size_t done = 0;
  core::Parallel(0).forEach(runs.size(), [&](std::size_t i) {
    const Drive& drive = drives[i / seeds];
    const std::uint64_t seed = o.first + i % seeds;
    runs[i] = toldBy(
        experiment::weightPairs(drive.drives.observe(seed), drive.config.slam, seed, o.which));
    const std::lock_guard lock(mutex);
    progress.tell("drives", static_cast<double>(++done) / static_cast<double>(runs.size()));
  });
  return runs;
}

/// The median of the runs' slopes, with the interval that the bootstrap over runs gives it.
std::string slopeText(std::vector<double> slopes) {
  if (slopes.empty()) return "";
  core::RandomStream rng(1, 0, 0, core::Purpose::resampling);
  const statistics::Interval interval = statistics::medianInterval(slopes, rng);
  std::sort(slopes.begin(), slopes.end());
  const std::size_t n = slopes.size();
  return fmt::format("{:.3f} [{:.3f} to {:.3f}]", (slopes[(n - 1) / 2] + slopes[n / 2]) / 2,
                     interval.low, interval.high);
}

void print(std::ostream& out, const std::vector<RunTold>& runs) {
  fmt::print(out, "| passed before | runs | pairs | nearer is heavier | k: median of the runs |\n");
  fmt::print(out, "|---|---|---|---|---|\n");
  for (std::size_t place = 0; place < kPlaces.size(); ++place) {
    std::vector<double> slopes;
    std::size_t pairs = 0;
    std::size_t right = 0;
    for (const RunTold& run : runs) {
      if (run[place].pairs == 0 || !std::isfinite(run[place].slope)) continue;
      slopes.push_back(run[place].slope);
      pairs += run[place].pairs;
      right += run[place].right;
    }
    if (pairs == 0) continue;
    fmt::print(out, "| {} | {} | {} | {:.1f} % | {} |\n", kPlaces[place], slopes.size(), pairs,
               100.0 * static_cast<double>(right) / static_cast<double>(pairs), slopeText(slopes));
  }
}

}  // namespace

int runWeights(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App program(kAboutWeights, "ariadne-eval weights");
  WeightsOptions o;
  declareWeights(program, o);
  if (!app::parseCommandLine(program, args, out)) return 0;
  if (o.last < o.first)
    throw core::UsageError(fmt::format("--last {} is under --first {}", o.last, o.first));
  print(out, mapAll(drivesOf(o), o));
  return 0;
}

}  // namespace ariadne::eval_app
