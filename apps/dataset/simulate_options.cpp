#include "simulate_options.h"

#include <map>

namespace ariadne {
namespace {

constexpr const char* kAboutSimulate =
    "A robot driven through a world: a rawlog, the true poses, the times of marks";

constexpr const char* kSimulateFooter =
    "Writes OUT, a rawlog; OUT.truth.tum, the true poses; OUT.marks.csv, when the drive's marks\n"
    "were passed. The formats of WORLD and PATH are explained in datasets/README.md.\n"
    "Example: ariadne-dataset simulate datasets/worlds/nested.world datasets/drives/nested.path "
    "\\\n"
    "           nested.rawlog --laps 6 --seed 7 --set noise.turn_per_root_m_deg=1\n"
    "Keys of --set, with their defaults:\n";

constexpr const char* kWorldFooter =
    "Examples:\n"
    "  ariadne-dataset world datasets/worlds/nested.world nested.png \\\n"
    "    --path datasets/drives/nested.path --laps 1\n"
    "  ariadne-dataset world --random office --seed 7 office7.world office7.png";

void addDriveOptions(CLI::App* sub, SimulateArguments& args) {
  sub->add_option("--laps", args.laps, "what `repeat laps` means in the drive");
  sub->add_option("--set", args.settings, "section.key=value; may be given again and again")
      ->allow_extra_args(false)
      ->take_all();
  sub->add_flag("-w,--overwrite", args.overwrite, "replace what is there");
}

}  // namespace

CLI::App* declareSimulate(CLI::App& app, SimulateArguments& args) {
  CLI::App* sub = app.add_subcommand("simulate", kAboutSimulate);
  sub->add_option("WORLD", args.world, "world to drive in")->required();
  sub->add_option("PATH", args.path, "drive: its waypoints")->required();
  sub->add_option("OUT", args.out, "rawlog to write")->required();
  sub->add_option("--seed", args.seed, "same seed, same noise; the true drive is always the same")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);  // else -1 would be 2^64 - 1
  addDriveOptions(sub, args);
  sub->footer(kSimulateFooter + simulationKeys());
  return sub;
}

CLI::App* declareWorld(CLI::App& app, SimulateArguments& args) {
  CLI::App* sub =
      app.add_subcommand("world", "A picture of a world, and of a drive in it; a random world");
  sub->add_option("WORLD", args.world, "world to draw; with --random the .world to write")
      ->required();
  sub->add_option("OUT", args.out, "PNG to write; with --random it may be left out");
  std::map<std::string, sim::RandomWorld> kinds;
  for (const auto& [name, kind] : sim::randomWorlds())
    if (kind != sim::RandomWorld::none) kinds.emplace(name, kind);
  sub->add_option("--random", args.random, "draw a world from the seed: office or corridors")
      ->transform(CLI::CheckedTransformer(kinds).description(""));
  sub->add_option("--seed", args.seed, "of --random: same seed, same world")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  sub->add_option("--path", args.path, "drive to draw: its waypoints");
  addDriveOptions(sub, args);
  sub->footer(kWorldFooter);
  return sub;
}

}  // namespace ariadne
