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
    "  ariadne-slam --continue ground_floor next.bag --start 3.5,-2,90\n"
    "  ariadne-slam ini/slam/carmen.ini drive.rawlog --truth drive.rawlog.truth.tum\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use, 130 stopped by Ctrl-C, 143 by SIGTERM.";

void declare(CLI::App& program, Options& o) {
  program.footer(kFooter);
  program.add_option("CONFIG", o.config_file, "INI file; may be left out before DATASET");
  program.add_option("DATASET", o.dataset, "log to map; default: the one the INI names");
  program.add_option("--continue", o.continue_from,
                     "go on in the map of a finished run: its folder, or a .simplemap. Without "
                     "CONFIG by that run's settings");
  program.add_option(
      "--start", o.start,
      "x,y,deg: where the robot is in that map at the first scan, to 1 m and 15 degrees; "
      "default: it is searched for");
  program.add_option(
      "--truth", o.truth,
      "true path as a TUM file, for report.html and ate_rmse_m in summary.json only");
  app::declareRunOptions(program, o, "dataset");
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
  if (options.config_file.empty() && !options.print_parameters && !options.continue_from)
    throw core::UsageError("which log, or which CONFIG? (see ariadne-slam --help)");
  sortFiles(options);
  if (options.continue_from && options.config_file.empty() && options.dataset.empty())
    throw core::UsageError("which log goes on from there? (see ariadne-slam --help)");
  return options;
}

}  // namespace ariadne::slam_app
