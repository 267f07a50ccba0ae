// All that can be configured of an exploration: world and robot, how it explores, how it maps.
#pragma once
#include <string>
#include <vector>

#include "ariadne/eval/loop_errors.h"
#include "ariadne/mission/mission.h"
#include "ariadne/sim/random_world.h"
#include "explore_options.h"
#include "run_folder.h"

namespace ariadne::explore_app {

struct WorldParams {
  std::string file;
  sim::RandomWorld random = sim::RandomWorld::none;
  double resolution_m = 0.05;
  std::string start;
};

template <class V>
void visitFields(V& v, WorldParams& p) {
  v.text("file", p.file,
         "world to explore: a drawn .world, a map of ROS (.yaml) or MRPT (.gridmap, .gridmap.gz), "
         "or a picture (.png, .pgm, .bmp); a relative path starts at the INI's folder, or at the "
         "current one on the command line");
  v.choice(
      "random", p.random, sim::randomWorlds(),
      "a world drawn from the run's seed in place of the file: office: corridors and furnished "
      "rooms; corridors: bare ones alone; none: the file");
  v.number("resolution_m", p.resolution_m, {0.01, 0.5}, "side of a pixel, for a picture only");
  v.text("start", p.start,
         "where the robot starts and looks: x,y,degrees in the frame of the world; empty: what the "
         "world says, else a place drawn from the seed");
}

/// How a map's walls are held against the world's, and from which score on they are right.
struct MapScoreParams {
  double tolerance_m = 0.25;
  double right_from = 0.93;
};

template <class V>
void visitFields(V& v, MapScoreParams& p) {
  v.number("tolerance_m", p.tolerance_m, {0.01, 10},
           "a wall of the map this near to a wall of the world is right");
  v.number("right_from", p.right_from, {0, 1},
           "least map_score of a correct run: one under it whose loops are closed right is bent");
}

struct ExploreConfig {
  WorldParams world;
  app::RunParams run;
  eval::CorrectBounds correct;
  MapScoreParams map_score;
  mission::MissionParams mission;
};

template <class Config, class F>
void forEachSection(Config& config, F&& f) {
  f("world", config.world);
  f("run", config.run);
  f("correct", config.correct);
  f("map_score", config.map_score);
  mission::forEachSection(config.mission, f);
}

struct ResolvedConfig {
  /// checked; world.file is absolute, run.out may be empty, the mapping follows the strategy
  ExploreConfig config;
  std::vector<std::string> warnings;
};

/// Defaults, then the INI, then --set in order, then the dedicated flags. Throws core::UsageError,
/// or core::Error when the INI cannot be read.
ResolvedConfig resolveConfig(const Options& options);

/// The world as [world] has it: its file, or one drawn from the run's seed. Throws as
/// sim::readWorld().
sim::World readWorldOf(const ExploreConfig& config);

/// Where the robot starts: by [world] start, else the world, else drawn from the seed.
/// Throws core::UsageError for a start that is no pose.
mrpt::math::TPose2D startOf(const ExploreConfig& config, const sim::World& world);

/// run.out, or a new name from the world's and the time.
std::string outputFolderOf(const ExploreConfig& config);

}  // namespace ariadne::explore_app
