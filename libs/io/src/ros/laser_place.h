// Where a laser is on the robot.
#pragma once
#include <mrpt/poses/CPose3D.h>

#include <optional>

#include "ariadne/io/ros_options.h"
#include "survey.h"

namespace ariadne::io::ros {

/// The frame that the odometry moves. Where its messages name none it is the only one that /tf has
/// below the odometry's frame; else empty.
std::string baseOf(const Survey& survey, const OdometrySource& odometry);

/// base_from_laser, or what the user says; nullopt where neither is known.
std::optional<mrpt::poses::CPose3D> placeOf(const Survey& survey, const RosOptions& options,
                                            const std::string& base, const std::string& frame);

/// Why it is not known, and what would help. @param odometry its topic
std::string whyNoPlace(const Survey& survey, const std::string& base, const std::string& frame,
                       const std::string& odometry);

}  // namespace ariadne::io::ros
