#include "experiment_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <ostream>
#include <thread>

#include "ariadne/core/error.h"
#include "ariadne/core/numbers.h"
#include "command_line.h"
#include "named_choice.h"
#include "submit_options.h"

namespace ariadne::experiment_app {
namespace {

constexpr const char* kAbout =
    "Runs an experiment: every arm (a program, an INI, settings) on the same seeds, at every\n"
    "combination of the factors' values; then tables with intervals and exact tests, plots and a\n"
    "page with all of it.";

constexpr const char* kFooter =
    "A run that has a result in FOLDER already is not done again: stop at any moment, by Ctrl-C "
    "or\n"
    "kill -9, and call run again. A run is done again when its INI, data, seed or program "
    "changed.\n"
    "How to write an experiment: doc/reference/experiments.md.\n"
    "Examples:\n"
    "  ariadne-experiment run ini/paper/small.ini --dry-run\n"
    "  ariadne-experiment run ini/paper/small.ini --out small --jobs 2\n"
    "  ariadne-experiment run ini/paper/path_overhead.ini --out some --where world=small,eight\n"
    "  ariadne-experiment status small\n"
    "  ariadne-experiment table small --format latex > small.tex\n"
    "  ariadne-experiment report small                 # plots and report.html, also on the way\n"
    "  ariadne-experiment export small doc/lab/experiments/results/small\n"
    "  ariadne-experiment work small --slice 3/10      # a tenth of the plan, on any machine\n"
    "  ariadne-experiment submit ini/paper/small.ini --out /shared/small --engine slurm\n"
    "  ariadne-experiment collect /shared/small\n"
    "Exit code: 0 fine, 1 a run failed or a file could not be written, 2 wrong use, 130 stopped "
    "by\n"
    "Ctrl-C, 143 by SIGTERM.";

/// "3/10".
void readSlice(const std::string& text, Options& o) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string_view whole = text;
  const auto slice = core::parseInteger<std::size_t>(whole.substr(0, slash));
  const auto slices =
      core::parseInteger<std::size_t>(whole.substr(std::min(slash + 1, text.size())));
  if (!slice || !slices || *slice < 1 || *slice > *slices)
    throw core::UsageError(
        fmt::format("--slice {}: takes i/n with i from 1 to n, as 3/10 (see --help)", text));
  o.slice = *slice;
  o.slices = *slices;
}

const std::map<std::string, batch::TableFormat>& formats() {
  static const std::map<std::string, batch::TableFormat> all = {
      {"text", batch::TableFormat::text},
      {"csv", batch::TableFormat::csv},
      {"markdown", batch::TableFormat::markdown},
      {"latex", batch::TableFormat::latex}};
  return all;
}

void addJobs(CLI::App* sub, Options& o) {
  sub->add_option("--jobs", o.jobs, "runs at a time; default: one per core")
      ->check(CLI::Range(1, 1024));
  sub->add_flag("--quiet", o.quiet, "print only warnings and errors");
}

}  // namespace

std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out) {
  Options o;
  std::string slice = "1/1";
  CLI::App app(kAbout, "ariadne-experiment");
  app.require_subcommand(1);
  app.footer(kFooter);
  CLI::App* run =
      app.add_subcommand("run", "Do all runs that have no result yet; table, plots and page");
  run->add_option("EXPERIMENT", o.ini, "INI of the experiment")->required();
  run->add_option("--out", o.folder, "results folder");
  addJobs(run, o);
  run->add_option("--first", o.first, "first seed, instead of the INI's")
      ->check(CLI::NonNegativeNumber);
  run->add_option("--last", o.last, "last seed, instead of the INI's")
      ->check(CLI::NonNegativeNumber);
  run->add_option("--where", o.where,
                  "FACTOR=VALUE,...: only these values of a factor; may be given for each")
      ->allow_extra_args(false)
      ->take_all();
  run->add_flag("--dry-run", o.dry_run, "show the plan and stop");
  run->add_flag("--again-failed", o.again_failed, "do runs that failed again");
  CLI::App* work = app.add_subcommand("work", "Do a slice of the plan in FOLDER, made by run");
  work->add_option("FOLDER", o.folder, "results folder")->required();
  work->add_option("--slice", slice, "i/n: the i-th of every n runs")->capture_default_str();
  addJobs(work, o);
  CLI::App* table = app.add_subcommand("table", "The table of what is finished");
  table->add_option("FOLDER", o.folder, "results folder")->required();
  table->add_option("--format", o.format, "text, csv, markdown or latex")
      ->transform(oneOf(formats()));
  CLI::App* plot =
      app.add_subcommand("plot", "Plots of what is finished: FOLDER/plots, SVG and PNG");
  plot->add_option("FOLDER", o.folder, "results folder")->required();
  CLI::App* report =
      app.add_subcommand("report", "The same and FOLDER/report.html, a page with all");
  report->add_option("FOLDER", o.folder, "results folder")->required();
  CLI::App* publish = app.add_subcommand(
      "export", "Tables in all formats, all runs as CSV, plots as SVG: what is worth committing");
  publish->add_option("FOLDER", o.folder, "results folder")->required();
  publish->add_option("TO", o.to, "folder to write to; files of these names are replaced")
      ->required();
  CLI::App* status = app.add_subcommand("status", "How far it is, and what failed");
  status->add_option("FOLDER", o.folder, "results folder")->required();
  CLI::App* submit = addSubmit(app, o);
  CLI::App* collect =
      app.add_subcommand("collect", "Tables, plots and page of what submit handed out");
  collect->add_option("FOLDER", o.folder, "results folder")->required();
  if (!ariadne::app::parseCommandLine(app, args, out)) return std::nullopt;
  readSlice(slice, o);
  o.command = *run       ? Command::run
              : *work    ? Command::work
              : *table   ? Command::table
              : *plot    ? Command::plot
              : *report  ? Command::report
              : *publish ? Command::publish
              : *submit  ? Command::submit
              : *collect ? Command::collect
                         : Command::status;
  if (o.jobs == 0)
    o.jobs = *submit ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (o.command == Command::run && o.folder.empty() && !o.dry_run)
    throw core::UsageError("--out is missing: the results folder, the same to go on (see --help)");
  return o;
}

}  // namespace ariadne::experiment_app
