// Whether a log and the map made of it make sense together. Pure: figures in, findings out.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "ariadne/checks/drive_watch.h"

namespace ariadne::checks {

/// One figure of a run that is looked at, and what is wrong where it is out of bounds.
struct Check {
  std::string name;     ///< as in summary.json
  double value = 0;     ///< a share or ratio
  std::string warning;  ///< empty where all is well; else what it means and what to turn
};

/// Of a log: what is known before it is mapped.
/// @param skipped scans of the laser that are not among the steps
std::vector<Check> checkLog(const DriveFigures& drive, std::size_t skipped);

/// What a filter made of the log.
struct MapFigures {
  std::size_t updates = 0;
  double path_m = 0;              ///< length of the path of s* over all scans
  std::size_t matches_tried = 0;  ///< 0 where the proposal does not match scans
  std::size_t matches_accepted = 0;
};

/// Of the map made of it, after the last update.
std::vector<Check> checkMap(const DriveFigures& drive, const MapFigures& map);

/// Those of the warnings that there are.
std::vector<std::string> warningsOf(const std::vector<Check>& checks);

}  // namespace ariadne::checks
