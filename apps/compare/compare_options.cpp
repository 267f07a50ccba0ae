#include "compare_options.h"

#include <ostream>

#include "ariadne/core/error.h"
#include "command_line.h"

namespace ariadne::compare_app {
namespace {

constexpr const char* kAbout =
    "Maps one log with ariadne-slam and with stock MRPT RBPF-SLAM, in turns, with the same "
    "particles,\n"
    "resolution, update distances, insertion range and seeds, and sets side by side what they "
    "cost\n"
    "and how good they are. CONFIG and DATASET are as ariadne-slam takes them; DATASET must be a\n"
    "rawlog of actions and frames (ariadne-dataset import makes one of a CARMEN log). Stock takes\n"
    "codes below the maximum range for walls: where ariadne-dataset info tells of some, import "
    "the\n"
    "log first, which writes them as no return.";

constexpr const char* kFooter =
    "Costs are those of whole processes, start-up and writing included. Repeat i has seed --seed + "
    "i - 1;\n"
    "a table's figure is the median of the repeats, with the least and the largest.\n"
    "Figures for --require: ours_NAME, stock_NAME (medians) and RATIO_ratio (ours over stock):\n"
    "  cpu_s, wall_s, memory_mb, updates, neff_share, length_m; with --truth ate_m, "
    "ate_heading_deg,\n"
    "  rpe_m, rpe_heading_deg; with --relations relations_m, relations_heading_deg.\n"
    "  Ratios are named without the unit: cpu_ratio, memory_ratio, ate_ratio, ...\n"
    "Examples:\n"
    "  ariadne-compare ini/slam/sena.ini\n"
    "  ariadne-compare ini/slam/carmen.ini drive.rawlog --truth drive.rawlog.truth.tum --repeats "
    "5\n"
    "  ariadne-compare ini/slam/sena.ini --require 'cpu_ratio<0.1' --require 'memory_ratio<0.2'\n"
    "Exit code: 0 fine, 1 a run failed or a requirement is not met, 2 wrong use.";

void declare(CLI::App& app, Options& o) {
  app.footer(kFooter);
  app.add_option("CONFIG", o.config_file, "INI of ariadne-slam or of rbpf-slam");
  app.add_option("DATASET", o.dataset, "log to map; default: the one the INI names");
  app.add_option("--repeats", o.repeats, "runs of each program")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--truth", o.truth, "true path, TUM: ATE and RPE (over 1 m)");
  app.add_option("--relations", o.relations, "verified relations, .gz or not: their mean errors");
  app.add_option("--max-gap", o.max_gap_s, "s between poses that are interpolated between")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--require", o.requirements,
                 "'NAME<NUMBER', also <=, > or >=; may be given again and again")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--out", o.out,
                 "folder for the runs and compare.html; default: ariadne-<dataset>-<date>-<time>");
  app.add_option("--json", o.json, "the figures as JSON, to this file");
  app.add_option("--set", o.settings, "section.key=value of ariadne-slam; again and again")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--particles", o.particles, "number of particles, both");
  app.add_option("--seed", o.seed, "of the first repeat, both");
  app.add_option("--threads", o.threads, "of ariadne-slam, 0: one per core; stock has one")
      ->capture_default_str()
      ->check(CLI::Range(0, 256));
  app.add_option("--pf-algorithm", o.pf_algorithm, "of stock; default: its INI's")
      ->check(CLI::Range(0, 3));
  app.add_option("--stock-ini", o.stock_ini,
                 "INI of rbpf-slam with stock's other settings; default: CONFIG if it is one, else "
                 "MRPT's for ICP-based grid mapping (Malaga)");
  app.add_option("--slam-program", o.slam_program, "default: ariadne-slam beside this program");
  app.add_option("--stock-program", o.stock_program,
                 "default: ariadne-stock-rbpf beside this program");
  app.add_flag("--overwrite", o.overwrite,
               "replace the files of an earlier comparison in that folder; others stay");
  app.add_flag("--quiet", o.quiet, "print only the table, warnings and errors");
}

}  // namespace

std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App app(kAbout, "ariadne-compare");
  Options options;
  declare(app, options);
  if (!ariadne::app::parseCommandLine(app, args, out)) return std::nullopt;
  if (options.config_file.empty())
    throw core::UsageError("which CONFIG? For one, ini/slam/sena.ini (see ariadne-compare --help)");
  return options;
}

}  // namespace ariadne::compare_app
