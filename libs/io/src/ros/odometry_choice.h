// Which odometry is used.
#pragma once
#include "ariadne/io/ros_options.h"
#include "survey.h"

namespace ariadne::io::ros {

/// Null where it cannot be told; `why` says so then, with what there is. @param laser_frame
/// transforms are looked for above it, where several could be the odometry
const OdometrySource* chooseOdometry(const Survey& survey, const RosOptions& options,
                                     const std::string& laser_frame, std::string& why);

}  // namespace ariadne::io::ros
