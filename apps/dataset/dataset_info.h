// What is in a log, and whether it can be mapped.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ariadne/io/dataset.h"

namespace ariadne {

struct LaserInfo {
  std::size_t scans = 0;
  std::size_t fewest_beams = 0;
  std::size_t most_beams = 0;
  double field_of_view_deg = 0;  ///< of the first scan, as all that follows
  double max_range_m = 0;
  double x_m = 0, y_m = 0, z_m = 0;  ///< the laser on the robot
  double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
  bool place_known = true;
  bool planar = true;
  std::size_t stamps = 0;
  double first_s = 0, last_s = 0;
  std::size_t stamps_backwards = 0;  ///< before the scan's before
  double set_back_s = 0;             ///< by how much, summed
  double longest_gap_s = 0;
  double rate_hz() const;
};

struct DatasetInfo {
  std::filesystem::path path;
  std::string format;
  std::uintmax_t bytes = 0;
  std::map<std::string, std::size_t> classes;
  std::map<std::string, LaserInfo> lasers;
  std::size_t increments = 0;  ///< odometry in actions
  std::size_t readings = 0;    ///< CObservationOdometry
  std::size_t line_poses = 0;  ///< on a laser's own line

  // Of the steps that a mapper would get, from the laser chosen.
  std::string laser;
  bool can_be_mapped = false;
  std::string why_not;
  io::DatasetCounts counts;
  std::vector<std::string> notes;  ///< what the records were taken to mean
  std::vector<std::string> warnings;
  double begin_s = 0;
  double duration_s = 0;
  double path_length_m = 0;
  double turned_deg = 0;  ///< sum of all turns, either way
  double longest_step_m = 0;
  double width_m = 0, height_m = 0;  ///< of the area that the odometry spans
};

/// Reads the file twice, for its contents and for its steps. With several lasers and none chosen
/// the steps are those of the first. Throws core::Error when the file is no log at all.
DatasetInfo collectInfo(const std::filesystem::path& path, io::DatasetOptions options,
                        const std::function<void(double)>& progress);

std::string infoAsText(const DatasetInfo& info);
std::string infoAsJson(const DatasetInfo& info);

}  // namespace ariadne
