// Where a laser sits on the robot: by the two poses of its lines, else by PARAMs.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <string>
#include <vector>

#include "carmen_params.h"

namespace ariadne::io {

struct LaserPlace {
  mrpt::math::TPose2D robot_from_laser;
  std::string source;  ///< "by its lines", "by PARAM ..."; empty: at the robot's centre
  std::string remark;  ///< what was odd
};

/// `offsets` are robot_from_laser of each line; empty where lines carry no poses.
LaserPlace placeOf(const std::vector<mrpt::math::TPose2D>& offsets,
                         const CarmenLaserParams& params);

}  // namespace ariadne::io
