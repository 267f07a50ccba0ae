// Odometry from the scans alone, for logs without any: each scan is matched to a map of the last
// metres, starting from where the robot would be had it gone on as before. It drifts like wheels do
// and is lost where scans show nothing, or the same all along a corridor.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <cstddef>

#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/models/scan_matcher.h"
#include "ariadne/models/sensor_step.h"

namespace ariadne::models {

/// Odometry made by matching each scan with the last ones, for logs without any.
class ScanOdometry {
 public:
  /// @param gain as the filter's proposal_gain
  ScanOdometry(const grid::GridParams& grid, const MatcherParams& matcher, double gain);

  /// Where the robot was at this step, seen from the first; the step's own odometry is not read.
  mrpt::math::TPose2D add(const SensorStep& step);
  /// Scans that fitted nowhere: there the robot is taken to have gone on as before.
  std::size_t lost() const { return lost_; }

 private:
  mrpt::math::TPose2D predicted(double time_s) const;
  void insert(const mrpt::obs::CObservation2DRangeScan& scan);

  grid::GridParams grid_;
  std::size_t max_beams_;
  ScanMatcher matcher_;
  mrpt::math::TPose2D pose_;
  mrpt::math::TPose2D motion_;  // of the last step
  double time_s_ = 0;
  double motion_s_ = 0;
  bool started_ = false;
  std::size_t lost_ = 0;
  grid::OccupancyGrid map_;   // matched against
  grid::OccupancyGrid next_;  // takes its place after some metres
  mrpt::math::TPose2D inserted_;
  double next_m_ = 0;  // distance since it was begun
};

}  // namespace ariadne::models
