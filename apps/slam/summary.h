// summary.json: the figures of a run, what made them and what they cost.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/checks/checks.h"
#include "ariadne/geometry/trajectory.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/ini_writer.h"
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
  std::vector<loops::ClosingRecord> closings;
  std::vector<loops::FoundClosure> found;
  models::MotionLearner learned = models::MotionLearner({});
  slam::DoubtCounts doubts;
  std::vector<checks::Check> checks;  ///< their warnings are among the warnings
  geometry::Trajectory path;          ///< of s*, one pose a scan
  io::DatasetCounts counts;
  std::string laser_label;
  Continuation from;  ///< its scans are the mapper's now
  std::vector<std::string> warnings;
  std::optional<TruthFit> truth;  ///< where a true path was given
  report::Replay replay;          ///< empty where no report is wanted
};

/// CPU time and peak memory are the process's until now.
/// @param writing_s wall clock that the other files took
nlohmann::ordered_json summaryOf(const RunResult& result, double writing_s,
                                 const std::vector<std::string>& files);

/// As text; bytes that are no UTF-8 (file names may be any) are replaced.
std::string jsonText(const nlohmann::ordered_json& json);

/// All parameters as in config.ini; numbers as numbers.
template <class Config>
nlohmann::ordered_json parametersJson(const Config& config) {
  nlohmann::ordered_json out;
  io::forEachWrittenSection(config, [&](const char* section, const auto& fields) {
    for (const io::WrittenField& f : fields) {
      const auto value = nlohmann::ordered_json::parse(f.value, nullptr, false);
      out[section][f.key] = value.is_discarded() ? nlohmann::ordered_json(f.value) : value;
    }
  });
  return out;
}

}  // namespace ariadne::slam_app
