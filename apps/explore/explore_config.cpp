#include "explore_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "ariadne/explore/strategy.h"
#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_text.h"
#include "ini_program.h"

namespace ariadne::explore_app {
namespace {

namespace fs = std::filesystem;

std::vector<io::IniEntry> flagEntries(const Options& o) {
  std::vector<io::IniEntry> entries = app::flagEntries(o);
  if (o.world) entries.push_back({"world", "file", *o.world, "--world"});
  if (o.random) {
    entries.push_back({"world", "file", "", "--random"});
    entries.push_back({"world", "random", *o.random, "--random"});
  }
  if (o.start) entries.push_back({"world", "start", *o.start, "--start"});
  if (o.strategy) entries.push_back({"explore", "strategy", *o.strategy, "--strategy"});
  return entries;
}

std::vector<std::string> warningsOf(const ExploreConfig& config) {
  std::vector<std::string> warnings;
  const auto& robot = config.mission.explore;
  const auto& truth = config.mission.sim.drive;
  if (robot.robot_radius_m < truth.robot_radius_m)
    warnings.push_back(
        fmt::format("[explore] robot_radius_m = {} is less than the robot's true one, [drive] "
                    "robot_radius_m = {}: it will touch walls",
                    robot.robot_radius_m, truth.robot_radius_m));
  if (isActive(robot.strategy) && !config.mission.slam.loop_closing.enabled)
    warnings.emplace_back("[loop_closing] enabled = false: no loop will be closed on purpose");
  return warnings;
}

bool isPicture(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".png" || ending == ".pgm" || ending == ".bmp";
}

/// office-7, of kind and seed.
std::string randomName(const ExploreConfig& config) {
  for (const auto& [name, kind] : sim::randomWorlds())
    if (kind == config.world.random)
      return fmt::format("{}-{}", name, config.mission.slam.filter.seed);
  return "";
}

}  // namespace

ResolvedConfig resolveConfig(const Options& options) {
  ResolvedConfig resolved;
  ExploreConfig& config = resolved.config;
  const fs::path file = options.config_file;
  const std::string text = io::readIniText(file);
  app::expectIniOf("ariadne-explore", file, text);
  io::applyIni(config, io::parseIniFile(text, file));
  std::string& world = config.world.file;
  if (!world.empty()) world = (file.parent_path() / world).string();
  for (const std::string& setting : options.settings)
    io::setField(config, io::parseSetting(setting));
  for (const io::IniEntry& entry : flagEntries(options)) io::setField(config, entry);
  if (!world.empty()) world = fs::absolute(world).lexically_normal().string();
  explore::applyStrategy(config.mission.explore.strategy, config.mission.slam);
  resolved.warnings = warningsOf(config);
  return resolved;
}

sim::World readWorldOf(const ExploreConfig& config) {
  const WorldParams& world = config.world;
  if (world.random != sim::RandomWorld::none)
    return sim::parseWorld(sim::randomWorld(world.random, config.mission.slam.filter.seed),
                           randomName(config));
  return isPicture(world.file) ? sim::readWorldPicture(world.file, world.resolution_m)
                               : sim::readWorld(world.file);
}

mrpt::math::TPose2D startOf(const ExploreConfig& config, const sim::World& world) {
  const std::string& text = config.world.start;
  if (text.empty()) {
    if (world.start) return *world.start;
    return sim::drawStart(world, config.mission.sim.drive.robot_radius_m,
                          config.mission.slam.filter.seed);
  }
  std::istringstream words(text);
  mrpt::math::TPose2D start;
  char first_comma = 0;
  char second_comma = 0;
  double degrees = 0;
  words >> start.x >> first_comma >> start.y >> second_comma >> degrees;
  const bool read = !words.fail() && first_comma == ',' && second_comma == ',';
  if (!read || !(words >> std::ws).eof())
    throw core::UsageError(
        fmt::format("[world] start = {}: it takes x,y,degrees, for instance 10,2.5,90", text));
  start.phi = degrees * M_PI / 180;
  return start;
}

std::string outputFolderOf(const ExploreConfig& config) {
  if (!config.run.out.empty()) return config.run.out;
  const bool drawn = config.world.random != sim::RandomWorld::none;
  return app::newFolderFor(drawn ? randomName(config) : config.world.file);
}

}  // namespace ariadne::explore_app
