#include "loops_app.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/experiment/drives.h"
#include "ariadne/experiment/loop_config_file.h"
#include "ariadne/experiment/run_figures.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/io/output_folder.h"
#include "ariadne/io/whole_file.h"
#include "command_line.h"
#include "ini_program.h"
#include "run_folder.h"
#include "run_program.h"

namespace ariadne {
namespace {

constexpr const char* kName = "ariadne-loop-experiment";
constexpr const char* kSummary = "summary.json";

constexpr const char* kAbout =
    "One run of the paper's nested-loop experiment: a simulated drive, or a log with made noise,\n"
    "mapped with recovery of particle diversity and without. Writes summary.json into a new\n"
    "folder. Many runs, their tables and tests: ariadne-experiment.";

constexpr const char* kFooter =
    "Examples:\n"
    "  ariadne-loop-experiment ini/paper/drives/nested.ini --laps 10 --seed 7\n"
    "  ariadne-loop-experiment ini/paper/drives/small.ini --oracle --laps 6 --out oracle\n"
    "  ariadne-experiment run ini/paper/nested_loop.ini --out nested_loop     60 such runs\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use.";

struct Options {
  std::string ini;
  std::string out;
  std::vector<std::string> settings;
  std::optional<int> laps;
  std::uint64_t seed = 1;
  bool oracle = false;
  bool overwrite = false;
  bool print_config = false;
};

void declare(CLI::App& program, Options& o) {
  program.footer(kFooter);
  program.add_option("CONFIG", o.ini, "INI of a drive, as ini/paper/drives/*.ini")->required();
  program.add_option("--laps", o.laps, "of the inner loop, where the drive has some");
  program.add_option("--seed", o.seed, "of noise and filter")->capture_default_str();
  program.add_flag("--oracle", o.oracle,
                   "maps the first loop with one filter per particle, with recovery and without, "
                   "in place of the pair; for small worlds");
  program.add_option("--set", o.settings, "section.key=value, over the INI")
      ->allow_extra_args(false)
      ->take_all();
  program.add_option("--out", o.out, "folder to write to; default: ariadne-<config>-<date>-<time>");
  program.add_flag("--overwrite", o.overwrite, "replace summary.json of an earlier run there");
  program.add_flag("--print-config", o.print_config, "print the resolved INI and stop");
}

experiment::LoopConfig configOf(const Options& o) {
  const std::string text = io::readIniText(o.ini);
  app::expectIniOf(kName, o.ini, text);
  return experiment::readLoopConfig(o.ini, text, o.settings);
}

/// What came out, and a line that tells it.
struct Told {
  experiment::RunFigures figures;
  std::string line;
};

Told mapped(const Options& o, const experiment::LoopConfig& config,
            const experiment::Drives& drives) {
  const auto seen = drives.observe(o.seed);
  if (!o.oracle) {
    const auto r = experiment::runLoop(seen, config.slam, config.correct, o.seed);
    if (r.standard.true_closures == 0)
      return {experiment::figuresOf(r), "the drive has no true loop to judge it by"};
    return {experiment::figuresOf(r),
            fmt::format("error across the loops: recovery {:.2f} m, standard {:.2f} m",
                        r.recovered.worst_translation_m, r.standard.worst_translation_m)};
  }
  const auto r = experiment::runOracle(seen, config.slam, config.correct, o.seed);
  if (!r) throw core::Error(fmt::format("seed {}: no loop was recovered", o.seed));
  return {experiment::figuresOf(*r),
          fmt::format("KL from the oracle's set: recovery {:.2f}, standard {:.2f} nats",
                      r->kl_recovered_nats, r->kl_standard_nats)};
}

int run(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App program(kAbout, kName);
  Options o;
  declare(program, o);
  if (!app::parseCommandLine(program, args, out)) return 0;
  const experiment::LoopConfig config = configOf(o);
  if (o.print_config) {
    out << io::writeIni(config, "Configuration of ariadne-loop-experiment.");
    return 0;
  }
  const experiment::Drives drives(config, o.laps);
  const std::filesystem::path folder = o.out.empty() ? app::newFolderFor(o.ini) : o.out;
  io::prepareOutputFolder(folder, {kSummary}, o.overwrite);
  const Told told = mapped(o, config, drives);
  nlohmann::ordered_json json{
      {"program", kName}, {"drive", drives.name()}, {"laps", drives.laps()}, {"seed", o.seed}};
  for (const auto& [name, value] : told.figures) json[name] = value;
  io::writeWhole(folder / kSummary, json.dump(1) + "\n");
  fmt::print(out, "{}, {} laps, seed {}: {}\n{}\n", drives.name(), drives.laps(), o.seed, told.line,
             (folder / kSummary).string());
  return 0;
}

}  // namespace

int runLoopsApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  return app::runProgram(kName, err, [&] { return run(args, out); });
}

}  // namespace ariadne
