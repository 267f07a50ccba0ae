// The subcommands that need no log: a simulated drive, and a picture of a world.
#pragma once
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/sim/random_world.h"

namespace ariadne {

struct SimulateArguments {
  std::filesystem::path world;
  std::filesystem::path path;  ///< for a picture: may be empty
  std::filesystem::path out;
  std::optional<int> laps;
  std::uint64_t seed = 1;
  std::vector<std::string> settings;  ///< section.key=value
  bool overwrite = false;
  std::optional<sim::RandomWorld> random;  ///< of drawWorld(): `world` is written first
};

/// Writes the rawlog, OUT.truth.tum (poses in the world's frame) and OUT.marks.csv (name,time_s).
/// Each throws core::Error; results go to `out`, progress to `err`.
void simulate(const SimulateArguments& args, std::ostream& out, std::ostream& err);
/// Writes a PNG of the world, and the drive in it if there is one; a random world first, and of
/// that a picture only where `out` names one.
void drawWorld(const SimulateArguments& args, std::ostream& out, std::ostream& err);

/// The keys that `settings` take, with defaults and meaning, a line each.
std::string simulationKeys();

}  // namespace ariadne
