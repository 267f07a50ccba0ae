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
    "  ariadne-explore ini/explore/office.ini --start 4,2,90 --set noise.turn_per_root_m_deg=1\n"
    "  ariadne-explore ini/explore/three_loops.ini --random office --seed 7\n"
    "The drive is mapped again, to the same bits, by: ariadne-slam OUT/mapping.ini\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use, 130 stopped by Ctrl-C, 143 by SIGTERM.";

void declare(CLI::App& program, Options& o) {
  program.footer(kFooter);
  program.add_option("CONFIG", o.config_file, "INI file");
  program.add_option("--world", o.world, "world to explore; default: the one the INI names");
  program
      .add_option("--random", o.random,
                  "explore a world drawn from the seed in place of the INI's: office or corridors")
      ->excludes("--world");
  program.add_option("--start", o.start,
                     "x,y,degrees; default: the INI's, else the world's, else drawn from the seed");
  program.add_option("--strategy", o.strategy, "what is done about loops, see below");
  app::declareRunOptions(program, o, "world");
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
