#include "neff_command.h"

#include <fmt/format.h>

#include <optional>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/experiment/loop_config_file.h"
#include "ariadne/io/ini_text.h"
#include "command_line.h"
#include "ini_program.h"
#include "neff_chart.h"
#include "neff_log.h"

namespace ariadne::eval_app {
namespace {

constexpr const char* kNeffFooter =
    "Example: ariadne-eval neff ini/paper/drives/nested.ini neff.png --laps 4";
constexpr const char* kLogFooter =
    "Example: ariadne-eval neff-log truth.tum neff.png --plain a-*/steps.csv --revisit "
    "b-*/steps.csv";

}  // namespace

int runNeff(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App program("Neff over one simulated drive, with plain weights and with revisit weights",
                   "ariadne-eval neff");
  program.footer(kNeffFooter);
  std::string ini;
  std::string png;
  std::optional<int> laps;
  std::uint64_t seed = 1;
  std::vector<std::string> settings;
  program.add_option("CONFIG", ini, "INI of ariadne-loop-experiment")->required();
  program.add_option("OUT", png, "PNG to write")->required();
  program.add_option("--laps", laps, "of the inner loop, where the drive has some");
  program.add_option("--seed", seed, "of noise and filter")->capture_default_str();
  program.add_option("--set", settings, "section.key=value, over the INI")
      ->allow_extra_args(false)
      ->take_all();
  if (!app::parseCommandLine(program, args, out)) return 0;
  const std::string text = io::readIniText(ini);
  app::expectIniOf("ariadne-loop-experiment", ini, text);
  const auto config = experiment::readLoopConfig(ini, text, settings);
  if (!config.files.log.empty())
    throw core::UsageError(ini + ": neff needs world and path, not a log");
  const sim::World world = sim::readWorld(config.files.world);
  const sim::DrivePath path = sim::readPath(config.files.path, laps);
  writeNeffChart(png, config, sim::driveThrough(world, path, config.sim.drive), seed);
  out << fmt::format("{}: Neff over the drive, plain and with the revisit weights\n", png);
  return 0;
}

int runNeffLog(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App program("Fall of Neff on new ground and on ground driven again, of recorded drives",
                   "ariadne-eval neff-log");
  program.footer(kLogFooter);
  std::string truth;
  std::string png;
  std::vector<std::string> plain;
  std::vector<std::string> revisit;
  program.add_option("TRUTH", truth, "TUM file of the true path")->required();
  program.add_option("OUT", png, "PNG to write")->required();
  program.add_option("--plain", plain, "steps.csv of ariadne-slam, filter.revisit_exponent = 0")
      ->required();
  program.add_option("--revisit", revisit, "steps.csv of the same drive with revisit weights")
      ->required();
  if (!app::parseCommandLine(program, args, out)) return 0;
  out << neffOfLog(png, truth, plain, revisit);
  return 0;
}

}  // namespace ariadne::eval_app
