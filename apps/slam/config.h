// All that can be configured of a run: the parameters of slam plus the sections [dataset], [run].
#pragma once
#include <string>
#include <vector>

#include "ariadne/io/dataset.h"
#include "ariadne/slam/params.h"
#include "continuation.h"
#include "options.h"
#include "run_folder.h"

namespace ariadne::slam_app {

/// Where the odometry comes from: the log, or scan after scan matched to the last ones.
enum class OdometrySource { log, scans };

struct DatasetParams {
  std::string file;
  OdometrySource odometry = OdometrySource::log;
  std::string laser_label;
  double field_of_view_deg = 0;
  double max_range_m = 0;
  double min_range_m = io::DatasetOptions().min_range_m;
  std::string scan_topic, odom_topic, odom_frame, base_frame;
  std::string laser_pose;
};

template <class V>
void visitFields(V& v, DatasetParams& p) {
  v.text(
      "file", p.file,
      "log to map: MRPT rawlog or CARMEN log, gzip or not, or a ROS recording (.bag, .db3, .mcap, "
      "or a folder of them); a relative path starts at the INI's folder, or at the current one "
      "on the command line");
  v.choice(
      "odometry", p.odometry,
      core::Choices<OdometrySource>{{"log", OdometrySource::log}, {"scans", OdometrySource::scans}},
      "the log's own; or made by matching scan after scan, for logs without any or with one "
      "that is wrong");
  v.text("laser_label", p.laser_label,
         "laser to use, where the log has several (ariadne-dataset info lists them)");
  v.number(
      "field_of_view_deg", p.field_of_view_deg, {0, 360},
      "angle that the laser's beams span, for a CARMEN log that does not say it (an error asks "
      "for it) or is wrong; 0: what the log says");
  v.number("max_range_m", p.max_range_m, {0, 1000},
           "readings at or over this are no return, m; 0: the log's maximum range, or its code for "
           "no return, told from the readings (ariadne-dataset info says which)");
  v.number("min_range_m", p.min_range_m, {0, 100},
           "readings under this are left out, m: Hokuyos send error codes of 1 to 19 mm as ranges");
  v.text("scan_topic", p.scan_topic,
         "of a ROS recording, as the next four: topic of the laser scans; empty: the only one");
  v.text("odom_topic", p.odom_topic,
         "topic of the odometry, nav_msgs/Odometry or transforms as /tf; empty: the only one");
  v.text("odom_frame", p.odom_frame,
         "where the odometry is read from transforms: the frame that it starts in; empty: the one "
         "called odom");
  v.text("base_frame", p.base_frame,
         "the robot's frame, which the odometry moves; empty: the one that the odometry names");
  v.text("laser_pose", p.laser_pose,
         "the laser on the robot, x y yaw_deg, as in 0.2 0 -90, and upside_down behind it for one "
         "that hangs; empty: what the recording's transforms say");
}

io::DatasetOptions optionsOf(const DatasetParams& params);

struct SlamConfig {
  DatasetParams dataset;
  app::RunParams run;
  ContinueParams continue_from;
  slam::SlamParams slam;
};

template <class Config, class F>
void forEachSection(Config& config, F&& f) {
  f("dataset", config.dataset);
  f("run", config.run);
  f("continue", config.continue_from);
  slam::forEachSection(config.slam, f);
}

struct ResolvedConfig {
  SlamConfig
      config;  ///< checked; dataset.file and continue_from.run are absolute, run.out may be empty
  std::vector<std::string> warnings;
};

/// Defaults, then the INI (ours or stock), then --set in order, then the dedicated flags.
/// Throws core::UsageError, or core::Error when the INI cannot be read.
ResolvedConfig resolveConfig(const Options& options);

/// run.out, or a new name from the dataset's and the time.
std::string outputFolderOf(const SlamConfig& config);

}  // namespace ariadne::slam_app
