// Configuration of the loop experiments: the drive, its noise, the mapping, what is correct.
#pragma once
#include <string>

#include "ariadne/eval/loop_errors.h"
#include "ariadne/io/motion_noise.h"
#include "ariadne/sim/params.h"
#include "ariadne/slam/params.h"

namespace ariadne::experiment {

/// Files of a drive: a world and a path through it, or a recorded log.
struct DriveFiles {
  std::string world;
  std::string path;
  std::string log;
};

template <class V>
void visitFields(V& v, DriveFiles& p) {
  v.text("world", p.world, "file of the world; a relative path starts at the INI's folder");
  v.text("path", p.path, "file of the scripted drive, likewise");
  v.text("log", p.log,
         "instead of both a log whose poses are the true ones, likewise or a name in "
         "ARIADNE_DATASETS or in a folder shared/datasets beside the project; [log_noise] makes "
         "its odometry");
}

/// Noise of a log's odometry, see io::MotionNoise.
struct LogNoise {
  io::MotionNoise motion{0, 0, 0, 0};
  double restamp_s = 0;
};

template <class V>
void visitFields(V& v, LogNoise& p) {
  v.number("rot_rot", p.motion.rot_rot, {0, 10}, "rad of heading per rad turned");
  v.number("rot_trans", p.motion.rot_trans, {0, 10}, "rad of heading per m");
  v.number("trans_trans", p.motion.trans_trans, {0, 10}, "m of place per m");
  v.number("trans_rot", p.motion.trans_rot, {0, 10}, "m of place per rad turned");
  v.number("restamp_s", p.restamp_s, {0, 10000},
           "stamps so far apart instead of the log's; 0 keeps them");
}

/// All settings of a loop experiment: the drive, the filter, how success is told.
struct LoopConfig {
  DriveFiles files;
  LogNoise log_noise;
  eval::CorrectBounds correct;
  sim::SimParams sim;
  slam::SlamParams slam;
};

template <class Config, class F>
void forEachSection(Config& config, F&& f) {
  f("experiment", config.files);
  f("log_noise", config.log_noise);
  f("correct", config.correct);
  sim::forEachSection(config.sim, f);
  slam::forEachSection(config.slam, f);
}

}  // namespace ariadne::experiment
