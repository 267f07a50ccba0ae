#include "loops_app.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <optional>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/experiment/loop_config.h"
#include "ariadne/experiment/loop_table.h"
#include "ariadne/io/dataset_place.h"
#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/io/ini_writer.h"
#include "command_line.h"
#include "ini_program.h"
#include "neff_chart.h"
#include "neff_log.h"
#include "run_command.h"

namespace ariadne {
namespace {

namespace fs = std::filesystem;
using experiment::LoopRow;

constexpr const char* kFooter =
    "A run that is in OUT already is not done again, and each is written when it is done: a "
    "stopped "
    "experiment goes on.\n"
    "Examples:\n"
    "  ariadne-loop-experiment run ini/experiments/nested.ini rows.csv --laps 10 --first 1 --last "
    "60\n"
    "  ariadne-loop-experiment table rows.csv\n"
    "  ariadne-loop-experiment run ini/experiments/small.ini oracle.csv --oracle --laps 6\n"
    "  ariadne-loop-experiment neff ini/experiments/nested.ini neff.png --laps 4\n"
    "  ariadne-loop-experiment neff-log truth.tum neff.png --plain a-*/steps.csv --revisit "
    "b-*/steps.csv";

struct Arguments {
  std::string ini;
  std::string rows;
  std::vector<std::string> tables;
  std::string truth;
  std::vector<std::string> plain;
  std::vector<std::string> revisit;
  std::vector<std::string> settings;
  std::optional<int> laps;
  loops_app::Seeds seeds;
  bool oracle = false;
  bool print_config = false;
};

experiment::LoopConfig configOf(const Arguments& args) {
  experiment::LoopConfig config;
  const std::string text = io::readIniText(args.ini);
  app::expectIniOf("ariadne-loop-experiment", args.ini, text);
  io::applyIni(config, io::parseIni(text, args.ini, io::IniDialect::strict));
  const fs::path folder = fs::path(args.ini).parent_path();
  for (std::string* file : {&config.files.world, &config.files.path})
    if (!file->empty()) *file = (folder / *file).string();
  for (const std::string& setting : args.settings) io::setField(config, io::parseSetting(setting));
  if (!config.files.log.empty())
    config.files.log = io::datasetPlace(config.files.log, folder).string();
  return config;
}

void drawNeff(const Arguments& args, std::ostream& out) {
  const experiment::LoopConfig config = configOf(args);
  if (!config.files.log.empty())
    throw core::UsageError(args.ini + ": neff needs world and path, not a log");
  const sim::World world = sim::readWorld(config.files.world);
  const sim::DrivePath path = sim::readPath(config.files.path, args.laps);
  loops_app::writeNeffChart(args.rows, config, sim::driveThrough(world, path, config.sim.drive),
                            args.seeds.first);
  fmt::print(out, "{}: Neff over the drive, plain and with the revisit weights\n", args.rows);
}

void printTable(const Arguments& args, std::ostream& out) {
  std::vector<LoopRow> rows;
  for (const std::string& file : args.tables)
    for (LoopRow& row : experiment::readRows(file)) rows.push_back(std::move(row));
  out << experiment::loopTable(rows);
}

int run(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  CLI::App app(
      "The nested-loop experiment of the paper: every seed is one simulated drive, mapped "
      "with recovery of particle diversity and without.",
      "ariadne-loop-experiment");
  app.require_subcommand(1);
  app.footer(kFooter);
  Arguments a;
  const auto addDrive = [&](CLI::App* sub, const char* about_out, const char* about_seed) {
    sub->add_option("INI", a.ini, "experiment, as ini/experiments/*.ini")->required();
    sub->add_option("OUT", a.rows, about_out);
    sub->add_option("--laps", a.laps, "of the inner loop, where the drive has some");
    sub->add_option("--first", a.seeds.first, about_seed)->capture_default_str();
    sub->add_option("--set", a.settings, "section.key=value, over the INI")
        ->allow_extra_args(false);
  };
  CLI::App* run = app.add_subcommand("run", "Paired runs, added to a CSV file");
  addDrive(run, "CSV file of the rows", "first seed");
  run->add_option("--last", a.seeds.last, "last seed")->capture_default_str();
  run->add_flag("--oracle", a.oracle,
                "instead of pairs the first loop with one filter a particle next to recovery and "
                "without; small worlds");
  run->add_flag("--print-config", a.print_config, "print the resolved INI and stop");
  CLI::App* neff = app.add_subcommand("neff", "Picture of Neff over one drive");
  addDrive(neff, "PNG to write", "the seed");
  neff->get_option("OUT")->required();
  CLI::App* table = app.add_subcommand("table", "Rates with intervals, tests and losses, Markdown");
  table->add_option("ROWS", a.tables, "CSV files")->required();
  CLI::App* log = app.add_subcommand(
      "neff-log", "Fall of Neff on new ground and on ground driven again, of recorded drives");
  log->add_option("TRUTH", a.truth, "TUM file of the true path")->required();
  log->add_option("OUT", a.rows, "PNG to write")->required();
  log->add_option("--plain", a.plain, "steps.csv of ariadne-slam, filter.revisit_exponent = 0")
      ->required();
  log->add_option("--revisit", a.revisit, "steps.csv of the same drive with revisit weights")
      ->required();
  if (!ariadne::app::parseCommandLine(app, args, out)) return 0;
  if (*run && a.print_config)
    out << io::writeIni(configOf(a), "Configuration of ariadne-loop-experiment.");
  else if (*run && a.rows.empty())
    throw core::UsageError("OUT is missing: the CSV file of the rows (see --help)");
  else if (*run)
    loops_app::runSeeds(configOf(a), a.laps, a.seeds, a.oracle, a.rows, err);
  else if (*neff)
    drawNeff(a, out);
  else if (*log)
    out << loops_app::neffOfLog(a.rows, a.truth, a.plain, a.revisit);
  else
    printTable(a, out);
  return 0;
}

}  // namespace

int runLoopsApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  try {
    return run(args, out, err);
  } catch (const core::UsageError& e) {
    fmt::print(err, "ariadne-loop-experiment: {}\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    fmt::print(err, "ariadne-loop-experiment: {}\n", e.what());
    return 1;
  }
}

}  // namespace ariadne
