#include "explore_options.h"

#include <ostream>

#include "ariadne/core/error.h"
#include "command_line.h"

namespace ariadne::explore_app {
namespace {

constexpr const char* kAbout =
    "Lets a simulated robot explore a world and map it with a Rao-Blackwellized particle filter;\n"
    "it closes loops on purpose and recovers the hypotheses that closing them cost. CONFIG is an\n"
    "INI of this program (ini/explore/*.ini). Writes maps, trajectories, the drive as a rawlog,\n"
    "every decision and a report into a new folder.";

constexpr const char* kFooter =
    "Strategies: frontier (loops are driven by chance only), active_uncertainty (a loop is left\n"
    "when the pose is as certain as at its entry, no recovery), active_neff (when Neff is\n"
    "constant), active_neff_recovery (the same, and diversity is recovered; the paper's).\n"
    "Values come from the defaults, then CONFIG, then --set, then the other options.\n"
    "Ctrl-C stops the robot and writes what there is; a second one stops at once.\n"
    "Examples:\n"
    "  ariadne-explore ini/explore/nested.ini\n"
    "  ariadne-explore ini/explore/three_loops.ini --strategy frontier --seed 7 --out frontier-7\n"
    "  ariadne-explore ini/explore/nested.ini --world mine.png --set world.resolution_m=0.1\n"
    "  ariadne-explore ini/explore/office.ini --start 4,2,90 --set noise.turn_per_m_deg=1\n"
    "The drive is mapped again, to the same bits, by: ariadne-slam OUT/mapping.ini\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use, 130 stopped by Ctrl-C, 143 by SIGTERM.";

void declare(CLI::App& app, Options& o) {
  app.footer(kFooter);
  app.add_option("CONFIG", o.config_file, "INI file");
  app.add_option("--world", o.world, "world to explore; default: the one the INI names");
  app.add_option("--start", o.start,
                 "x,y,degrees; default: the INI's, else the world's, else drawn from the seed");
  app.add_option("--strategy", o.strategy, "what is done about loops, see below");
  app.add_option("--seed", o.seed, "same seed, same result, on any number of threads");
  app.add_option("--particles", o.particles, "number of particles");
  app.add_option("--set", o.settings, "section.key=value; may be given again and again")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--threads", o.threads, "0: one a core");
  app.add_option("--out", o.out, "folder to write to; default: ariadne-<world>-<date>-<time>");
  app.add_flag("--overwrite", o.overwrite,
               "replace the files of an earlier run in that folder; others stay");
  app.add_flag("--no-pictures", o.no_pictures, "write no PNG files and no report.html");
  app.add_flag("--print-config", o.print_config, "print the resolved INI and stop");
  app.add_flag("--print-parameters", o.print_parameters,
               "print the page of all parameters (Markdown) and stop");
  app.add_flag("--quiet", o.quiet, "print only warnings and errors");
}

}  // namespace

std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App app(kAbout, "ariadne-explore");
  Options options;
  declare(app, options);
  if (!ariadne::app::parseCommandLine(app, args, out)) return std::nullopt;
  if (options.config_file.empty() && !options.print_parameters)
    throw core::UsageError(
        "which CONFIG? For one, ini/explore/nested.ini (see ariadne-explore --help)");
  return options;
}

}  // namespace ariadne::explore_app
