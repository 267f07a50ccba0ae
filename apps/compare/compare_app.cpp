#include "compare_app.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/io/output_folder.h"
#include "ariadne/io/relations.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/find_program.h"
#include "beginning.h"
#include "compare_options.h"
#include "comparison_output.h"
#include "comparison_page.h"
#include "repeats.h"
#include "run_folder.h"
#include "run_program.h"
#include "stock_settings.h"
#include "summary.h"

namespace ariadne {
namespace {

using namespace compare_app;
namespace fs = std::filesystem;

constexpr const char* kName = "ariadne-compare";
constexpr const char* kPage = "compare.html";

/// As ariadne-slam resolves it.
slam_app::ResolvedConfig configOf(const Options& options) {
  slam_app::Options slam;
  slam.config_file = options.config_file;
  slam.dataset = options.dataset;
  slam.settings = options.settings;
  slam.particles = options.particles;
  slam.seed = options.seed;
  slam.threads = std::to_string(options.threads);
  auto resolved = slam_app::resolveConfig(slam);
  resolved.config.run.pictures = true;
  resolved.config.run.out.clear();
  const auto last_seed =
      resolved.config.slam.filter.seed + static_cast<std::uint64_t>(options.repeats - 1);
  if (last_seed > std::numeric_limits<std::int32_t>::max())
    throw core::UsageError(fmt::format("seeds up to {}: stock takes 0 to 2147483647", last_seed));
  if (const std::string& known = resolved.config.continue_from.run; !known.empty())
    throw core::UsageError(fmt::format(
        "[continue] run = {}: stock MRPT cannot go on in a map, so there is nothing to compare; "
        "with --set continue.run= both begin a new one",
        core::printable(known)));
  const std::string& dataset = resolved.config.dataset.file;
  if (dataset.empty()) throw core::UsageError("no dataset: name one behind CONFIG");
  if (std::error_code ignored; !fs::exists(dataset, ignored))
    throw core::Error(
        fmt::format("there is no log {}; to map another, name it behind CONFIG", dataset));
  return resolved;
}

/// Throws now, not after the runs, for files that cannot be read.
References referencesOf(const Options& options) {
  if (!options.truth.empty()) io::readTum(options.truth);
  if (!options.relations.empty()) io::readRelations(options.relations);
  return {options.truth, options.relations, options.max_gap_s};
}

std::string settingsText(const slam_app::SlamConfig& c) {
  const auto& s = c.slam;
  return fmt::format(
      "{} particles, cells of {:g} m, an update each {:g} m or {:g} degrees, insertion to {:g} m, "
      "seeds from {}; ariadne-slam on {}, stock on one.",
      s.filter.particles, s.grid.resolution_m, s.update.update_distance_m,
      s.update.update_angle_deg, s.grid.insert_range_m, s.filter.seed,
      c.run.threads == 0   ? "all cores"
      : c.run.threads == 1 ? "one thread"
                           : fmt::format("{} threads", c.run.threads));
}

std::vector<Requirement> requirementsOf(const Options& options) {
  const auto names = valueNames(figureKinds({options.truth, options.relations}));
  const auto all = valueNames(figureKinds({"any", "any"}));
  std::vector<Requirement> requirements;
  for (const std::string& text : options.requirements)
    requirements.push_back(parseRequirement(text, names, all));
  return requirements;
}

void checkJsonFile(const std::string& file) {
  if (file.empty()) return;
  const fs::path folder = fs::absolute(file).parent_path();
  if (std::error_code ignored; !fs::is_directory(folder, ignored))
    throw core::UsageError(fmt::format("--json {}: there is no folder {}", file, folder.string()));
}

/// `given` if not empty, else the program of this name beside the running one, else on PATH.
std::string programOf(const std::string& given, const std::string& name) {
  if (!given.empty()) {
    if (!process::canRun(given)) throw core::UsageError(given + " is no program that can be run");
    return fs::absolute(given).string();
  }
  const fs::path found = process::findSister(name);
  if (found.empty())
    throw core::UsageError(fmt::format(
        "{} is neither beside this program nor on PATH: build or install all of Ariadne", name));
  return found.string();
}

/// Everything that can be wrong is found here, before the long runs.
Contest contestOf(const Options& options, const slam_app::SlamConfig& config,
                  const fs::path& stock_base) {
  Contest contest;
  contest.slam_program = programOf(options.slam_program, "ariadne-slam");
  contest.stock_program = programOf(options.stock_program, "ariadne-stock-rbpf");
  contest.ours = config;
  contest.stock_ini = stockIniText(stock_base, config.slam, options.pf_algorithm);
  contest.references = referencesOf(options);
  contest.repeats = options.repeats;
  contest.folder =
      fs::absolute(options.out.empty() ? app::newFolderFor(config.dataset.file) : options.out);
  contest.overwrite = options.overwrite;
  io::prepareOutputFolder(contest.folder, {kPage}, options.overwrite);
  return contest;
}

/// Of all runs; tells beforehand how long they take, and how far they are.
std::vector<ComparedFigure> figuresOf(const Contest& contest, bool quiet, std::ostream& err) {
  writeInis(contest);
  Forecast forecast(contest.repeats);
  app::Progress progress(err, app::progressStyle(quiet, err));
  const LogUpdates updates(contest.ours);
  if (!quiet) {
    tryBeginnings(contest, updates, forecast);
    if (const std::string text = forecast.text(); !text.empty())
      fmt::print(err, "{}: {}\n", kName, text);
  }
  return runContest(contest, updates, forecast, progress);
}

int compare(const Options& options, std::ostream& out, std::ostream& err) {
  const auto resolved = configOf(options);
  app::warn(err, kName, resolved.warnings);
  const std::vector<Requirement> requirements = requirementsOf(options);
  checkJsonFile(options.json);
  const fs::path stock_base = stockBase(options.stock_ini, options.config_file);
  const Contest contest = contestOf(options, resolved.config, stock_base);

  Comparison comparison;
  comparison.dataset = resolved.config.dataset.file;
  comparison.stock_base = stock_base.string();
  comparison.settings = settingsText(resolved.config);
  comparison.figures = figuresOf(contest, options.quiet, err);
  out << comparisonText(comparison, requirements) << std::flush;  // first: files may fail
  if (!options.json.empty())
    io::writeWhole(options.json, slam_app::jsonText(comparisonJson(comparison, requirements)));
  io::writeWhole(contest.folder / kPage,
                 comparisonPage(comparison, requirements, oursFolder(contest, 1) / "overview.png",
                                stockFolder(contest, 1) / "overview.png"));
  if (!options.quiet) fmt::print(out, "\nBoth maps: {}\n", (contest.folder / kPage).string());
  for (const Requirement& r : requirements)
    if (!r.metBy(valueOf(comparison, r.name))) return 1;
  return 0;
}

}  // namespace

int runCompareApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  return app::runProgram(kName, err, [&] {
    const auto options = parseOptions(args, out);
    return options ? compare(*options, out, err) : 0;
  });
}

}  // namespace ariadne
