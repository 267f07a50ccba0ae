// An experiment's INI: arms, factors, seeds, figures, limits (doc/reference/experiments.md).
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ariadne/batch/plot_choice.h"
#include "ariadne/batch/success.h"
#include "ariadne/io/ini_text.h"

namespace ariadne::batch {

/// `section.key=value` of an arm, with its place in the INI.
struct Setting {
  std::string key;
  std::string value;
};

/// An arm of an experiment, as its section [arm.NAME] says.
struct Arm {
  std::string name;
  std::string where;  ///< of the section, for errors
  std::string program;
  std::string config;
  std::string dataset;
  std::string truth;  ///< TUM file of the true path, for the figure ate_rmse_m
  std::vector<std::string> args;
  std::vector<Setting> settings;
  std::string prefix;  ///< before the names of [figures], for a program that tells of several arms
};

/// What a factor's values do: they are given to `key`, or each is the name of some settings.
struct Factor {
  std::string name;
  std::string where;
  std::string key;  ///< section.key that is set, or an option: --laps; empty: see `settings`
  std::vector<std::string> values;
  std::map<std::string, std::vector<Setting>> settings;  ///< by value; one without has none
};

/// Section [limits] of an experiment: what a run may take before it is ended and counts as failed.
struct Limits {
  double time_s = 3600;  ///< wall clock of a run
  int threads = 1;       ///< of a run; the result is the same on any number
  bool keep_files = false;
};

/// An experiment's INI, read and checked; nothing is planned yet.
struct Experiment {
  std::filesystem::path file;
  std::string text;  ///< of the file
  std::string title;
  std::vector<Arm> arms;
  std::vector<Factor> factors;
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 10;
  std::vector<std::string> figures;   ///< of which tables give the median
  std::vector<std::string> relative;  ///< of these, also the change from the first arm
  Success success;
  PlotChoice plots;
  Limits limits;
};

/// Strict. Throws core::UsageError with file, line, section and key, and what would be right.
Experiment parseExperiment(std::string_view text, const std::filesystem::path& file);
/// Throws core::Error when the file cannot be read.
Experiment readExperiment(const std::filesystem::path& file);

}  // namespace ariadne::batch
