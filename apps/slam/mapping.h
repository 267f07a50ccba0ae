// The run itself: every step of a dataset through the mapper.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ariadne/checks/drive_watch.h"
#include "ariadne/geometry/trajectory.h"
#include "ariadne/io/dataset.h"
#include "ariadne/slam/mapper.h"
#include "config.h"
#include "interrupt.h"
#include "progress.h"

namespace ariadne::slam_app {

struct MappingRecord {
  std::vector<slam::StepReport> reports;  ///< one a filter update
  geometry::Trajectory odometry;          ///< odom_from_robot at every step
  checks::DriveFigures drive;
  std::size_t scans_lost = 0;  ///< of odometry by scans: those that fitted nowhere
  double reading_s = 0;        ///< wall clock, within total_s
  double recording_s = 0;      ///< the listener's, within total_s
  double total_s = 0;
  int signal = 0;  ///< that stopped the run early, 0 if none
};

/// Called after each filter update.
using UpdateListener = std::function<void(const slam::StepReport&)>;

/// Maps until the steps end or a signal comes. With odometry from the scans the steps' own is not
/// read, and the record's is what was made.
MappingRecord mapSteps(io::StepSource& source, slam::Mapper& mapper, const SlamConfig& config,
                       const app::Interrupt& interrupt, app::Progress& progress,
                       const UpdateListener& listener);

/// "  45 %  1234 scans  310 scans/s  Neff 23.1 of 30  0:12 left".
/// @param fraction of the dataset that was read, 0 to 1
std::string progressLine(double fraction, std::size_t scans, double elapsed_s, double neff,
                         std::size_t particles);

}  // namespace ariadne::slam_app
