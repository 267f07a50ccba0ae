// What the robot knows when it decides: a narrow view of the filter, and its sensors.
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

#include "ariadne/filter/ancestry.h"
#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/loops/closing/loop_watcher.h"
#include "ariadne/slam/mapper.h"

namespace ariadne::explore {

/// Of s* after a scan; good until the filter takes the next one.
struct Belief {
  double time_s = 0;                               ///< of the scan, from any moment on
  std::size_t updates = 0;                         ///< of the filter, up to now
  mrpt::math::TPose2D map_from_robot;              ///< now
  const grid::OccupancyGrid& map;                  ///< of s*
  filter::AncestorPtr path;                        ///< s*'s poses, update by update
  std::vector<const loops::Closing*> open;         ///< closings, the outermost first
  const mrpt::obs::CObservation2DRangeScan& scan;  ///< the latest
  bool touched = false;                            ///< the bumper's word since the last scan
};

/// @param mapper has processed the scan
Belief beliefOf(const slam::Mapper& mapper, double time_s,
                const mrpt::obs::CObservation2DRangeScan& scan, bool touched);

}  // namespace ariadne::explore
