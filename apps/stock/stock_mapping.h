// The loop of MRPT's rbpf-slam over a rawlog (mrpt/libs/apps/src/RBPF_SLAM_App.cpp, 2.5.8).
#pragma once
#include <mrpt/slam/CMetricMapBuilderRBPF.h>

#include <string>

#include "ariadne/geometry/trajectory.h"

namespace ariadne::stock_app {

struct StockRun {
  geometry::Trajectory mean;  ///< mean of the particles at every scan, as it was then
  geometry::Trajectory path;  ///< of the best particle in the end, a pose at every scan
  std::size_t updates = 0;    ///< of the filter
  /// Neff / N behind an update, 1 where it resampled (MRPT tells no other); mean and least of all.
  double neff_share_mean = 0;
  double neff_share_min = 0;
};

/// Feeds every pair of action and frame to the builder.
/// Throws core::Error naming the file when it cannot be read or holds no such pairs.
StockRun mapRawlog(const std::string& rawlog, mrpt::slam::CMetricMapBuilderRBPF& builder);

}  // namespace ariadne::stock_app
