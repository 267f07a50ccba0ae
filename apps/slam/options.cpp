#include "options.h"

#include <fmt/format.h>

#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/io/log_or_ini.h"
#include "command_line.h"

namespace ariadne::slam_app {
namespace {

constexpr const char* kAbout =
    "Maps a dataset of 2D laser scans and odometry with a Rao-Blackwellized particle filter.\n"
    "CONFIG is an INI of this program (ini/slam/*.ini) or one of MRPT's rbpf-slam for laser "
    "grids;\n"
    "DATASET an MRPT rawlog, a CARMEN log, gzip or not, or a ROS recording (.bag, .db3, .mcap, or "
    "a\n"
    "folder of them). A DATASET alone is mapped with the default settings. Writes maps,\n"
    "trajectories and figures into a new folder.";

constexpr const char* kFooter =
    "Values come from the defaults, then CONFIG, then --set, then the other options.\n"
    "Ctrl-C stops mapping and writes what there is; a second one stops at once.\n"
    "Examples:\n"
    "  ariadne-slam drive.bag\n"
    "  ariadne-slam ini/slam/sena.ini\n"
    "  ariadne-slam ini/slam/carmen.ini intel.clf.gz --out intel --particles 50 --seed 7\n"
    "  ariadne-slam ini/slam/carmen.ini fr079.log --set grid.resolution_m=0.1 --threads 1\n"
    "  ariadne-slam ini/slam/ros.ini drive.bag --set dataset.scan_topic=/front/scan\n"
    "  ariadne-slam ini/slam/sena.ini --print-config > mine.ini\n"
    "  ariadne-slam ini/slam/carmen.ini drive.rawlog --truth drive.rawlog.truth.tum\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use, 130 stopped by Ctrl-C, 143 by SIGTERM.";

void declare(CLI::App& app, Options& o) {
  app.footer(kFooter);
  app.add_option("CONFIG", o.config_file, "INI file; may be left out before DATASET");
  app.add_option("DATASET", o.dataset, "log to map; default: the one the INI names");
  app.add_option("--set", o.settings, "section.key=value; may be given again and again")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--particles", o.particles, "number of particles");
  app.add_option("--seed", o.seed, "same seed, same result, on any number of threads");
  app.add_option("--threads", o.threads, "0: one a core");
  app.add_option("--out", o.out, "folder to write to; default: ariadne-<dataset>-<date>-<time>");
  app.add_option("--truth", o.truth,
                 "true path as a TUM file, for report.html and ate_rmse_m in summary.json only");
  app.add_flag("--overwrite", o.overwrite,
               "replace the files of an earlier run in that folder; others stay");
  app.add_flag("--no-pictures", o.no_pictures, "write no PNG files and no report.html");
  app.add_flag("--print-config", o.print_config, "print the resolved INI and stop");
  app.add_flag("--print-parameters", o.print_parameters,
               "print the page of all parameters (Markdown) and stop");
  app.add_flag("--quiet", o.quiet, "print only warnings and errors");
}

/// A log may stand in the place of CONFIG.
void sortFiles(Options& o) {
  if (!io::looksLikeLog(o.config_file)) return;
  if (!o.dataset.empty())
    throw core::UsageError(
        fmt::format("{} is a log, not an INI: CONFIG stands before DATASET", o.config_file));
  std::swap(o.config_file, o.dataset);
}

}  // namespace

std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App app(kAbout, "ariadne-slam");
  Options options;
  declare(app, options);
  if (!ariadne::app::parseCommandLine(app, args, out)) return std::nullopt;
  if (options.config_file.empty() && !options.print_parameters)
    throw core::UsageError("which log, or which CONFIG? (see ariadne-slam --help)");
  sortFiles(options);
  return options;
}

}  // namespace ariadne::slam_app
