// A sensor_msgs/LaserScan as MRPT's scan.
#pragma once
#include <mrpt/poses/CPose3D.h>

#include "ariadne/io/dataset_records.h"
#include "messages.h"

namespace ariadne::io::ros {

/// Beam i looks to angle_min + i angle_increment, either way round; ranges as REP 117 has them:
/// +inf and what is not under range_max is no return, -inf, NaN and what is under range_min is bad.
/// A range_max that no laser has (0, over 1 km, NaN) is replaced by 80 m. Its time is left to the
/// caller.
LaserRecord recordOf(const LaserScan& scan, const std::string& label,
                     const mrpt::poses::CPose3D& robot_from_laser);

}  // namespace ariadne::io::ros
