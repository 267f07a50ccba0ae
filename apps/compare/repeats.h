// The runs of a comparison, in turns.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "comparison.h"
#include "config.h"

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

/// Where repeat i (from 1) of each program writes.
std::filesystem::path oursFolder(const Contest& contest, int repeat);
std::filesystem::path stockFolder(const Contest& contest, int repeat);

/// Writes both INIs into the folder, runs ours, stock, ours, stock, ... and gives the figures.
/// @param tell called with a line before each run
/// Throws core::Error when a run fails.
std::vector<ComparedFigure> runContest(const Contest& contest,
                                       const std::function<void(const std::string&)>& tell);

}  // namespace ariadne::compare_app
