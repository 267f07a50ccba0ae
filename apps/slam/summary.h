// summary.json: the figures of a run, what made them and what they cost.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ariadne/io/dataset.h"
#include "ariadne/report/replay.h"
#include "config.h"
#include "mapping.h"
#include "truth.h"

namespace ariadne::slam_app {

/// What a run knows once mapping has ended.
struct RunResult {
  SlamConfig config;
  MappingRecord record;
  slam::StageTimes stages;
  std::vector<slam::ClosingRecord> closings;
  models::Trajectory path;  ///< of s*, one pose a scan
  io::DatasetCounts counts;
  std::string laser_label;
  std::vector<std::string> warnings;
  std::optional<TruthFit> truth;  ///< where a true path was given
  report::Replay replay;          ///< empty where no report is wanted
};

/// Sum of the distances between successive poses, m.
double lengthOf(const models::Trajectory& path);

/// @param writing_s wall clock that the other files took; @param files that were written.
/// CPU time and peak memory are the process's until now.
std::string summaryJson(const RunResult& result, double writing_s,
                        const std::vector<std::string>& files);

}  // namespace ariadne::slam_app
