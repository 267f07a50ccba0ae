// The runs of a comparison, in turns.
#pragma once
#include <filesystem>
#include <string>

#include "comparison.h"
#include "config.h"
#include "forecast.h"
#include "log_updates.h"
#include "progress.h"

namespace ariadne::compare_app {

/// The programs and what they are given.
struct Contest {
  std::string slam_program;
  std::string stock_program;
  slam_app::SlamConfig ours;  ///< its dataset and seed are both programs'
  std::string stock_ini;      ///< text
  std::filesystem::path folder;
  bool overwrite = false;  ///< files of earlier runs in that folder
  int repeats = 1;
  References references;
};

/// The commands of repeat i (from 1), which write into the folders below; stock's folder is made.
std::vector<std::string> oursCommand(const Contest& contest, int repeat);
std::vector<std::string> stockCommand(const Contest& contest, int repeat);

/// Where repeat i (from 1) of each program writes.
std::filesystem::path oursFolder(const Contest& contest, int repeat);
std::filesystem::path stockFolder(const Contest& contest, int repeat);

/// Writes both INIs into the folder, as the programs are given them. Throws core::Error.
void writeInis(const Contest& contest);

/// Runs ours, stock, ours, stock, ... on writeInis()'s and gives the figures.
/// @param updates of the log, by which a run's progress is told
/// @param forecast of what is known already; takes what each run took
/// Throws core::Error when a run fails.
std::vector<ComparedFigure> runContest(const Contest& contest, const LogUpdates& updates,
                                       Forecast& forecast, app::Progress& progress);

}  // namespace ariadne::compare_app
