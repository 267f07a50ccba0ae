#include <sstream>

#include "ariadne/batch/experiment.h"
#include "ariadne/experiment/loop_config.h"
#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/io/log_or_ini.h"
#include "ariadne/io/whole_file.h"
#include "config.h"
#include "parts.h"
#include "requirement.h"

namespace ariadne::fuzz {

/// Ours or stock's.
void readSlamIni(const Path& file) {
  slam_app::Options options;
  options.config_file = file.string();
  io::writeIni(slam_app::resolveConfig(options).config, "");
}

/// Whether ariadne-slam takes it for a log.
void readLogOrIni(const Path& file) { io::looksLikeLog(file); }

void readLoopIni(const Path& file) {
  experiment::LoopConfig config;
  io::applyIni(config, io::parseIni(io::readIniText(file), "in.ini", io::IniDialect::strict));
}

void readExperimentIni(const Path& file) { batch::readExperiment(file); }

/// A setting a line.
void readSettings(const Path& file) {
  slam_app::SlamConfig config;
  std::istringstream lines(io::readWhole(file));
  for (std::string line; std::getline(lines, line);) io::setField(config, io::parseSetting(line));
}

void readRequirement(const Path& file) {
  compare_app::parseRequirement(io::readWhole(file), {"cpu_ratio", "ours_updates"}, {"ate_ratio"});
}

}  // namespace ariadne::fuzz
