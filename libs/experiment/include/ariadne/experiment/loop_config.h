// Configuration of the nested-loop experiment: the drive, its noise, the mapping, what is correct.
#pragma once
#include <string>

#include "ariadne/eval/loop_errors.h"
#include "ariadne/sim/params.h"
#include "ariadne/slam/params.h"

namespace ariadne::experiment {

struct DriveFiles {
  std::string world;
  std::string path;
};

template <class V>
void visitFields(V& v, DriveFiles& p) {
  v.text("world", p.world, "file of the world; a relative path starts at the INI's folder");
  v.text("path", p.path, "file of the scripted drive, likewise");
}

struct LoopConfig {
  DriveFiles files;
  eval::CorrectBounds correct;
  sim::SimParams sim;
  slam::SlamParams slam;
};

template <class Config, class F>
void forEachSection(Config& config, F&& f) {
  f("experiment", config.files);
  f("correct", config.correct);
  sim::forEachSection(config.sim, f);
  slam::forEachSection(config.slam, f);
}

}  // namespace ariadne::experiment
