// The files of a run.
#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "ariadne/slam/mapper.h"
#include "summary.h"

namespace ariadne::slam_app {

/// All that a file may be made of.
struct Material {
  const slam::Mapper& mapper;
  const RunResult& result;
  const mrpt::maps::COccupancyGridMap2D& map;  ///< of s*
};

struct Output {
  std::vector<std::string> names;  ///< the first is given to `write`, which makes all of them
  std::string purpose;
  bool is_picture = false;
  std::function<void(const std::filesystem::path& file, const Material& m)> write;
};

/// The INI that maps the run's dataset again.
Output mappingIni(const std::string& name);

/// The files that a run with this configuration writes besides its INI and summary.json, in the
/// order of writing: what could not be had again comes first, should the disk fill up.
std::vector<Output> mappingOutputs(const SlamConfig& config);

/// Names of their files and of summary.json.
std::vector<std::string> namesOf(const std::vector<Output>& outputs);

/// The text of summary.json. @param writing_s wall clock that the other files took
/// @param files that were written
using SummaryText =
    std::function<std::string(double writing_s, const std::vector<std::string>& files)>;

/// Writes all files, each whole or not at all, and says on `out` what each is for. One that fails
/// does not keep the others from being written; then throws core::Error that names those that
/// failed. Throws core::Error at once when the map is empty.
void writeOutputs(const std::filesystem::path& folder, const std::vector<Output>& outputs,
                  const slam::Mapper& mapper, const RunResult& result, const SummaryText& summary,
                  std::ostream& out);

}  // namespace ariadne::slam_app
