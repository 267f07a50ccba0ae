// Which laser, which odometry, and where the laser is: by themselves where there is one of each,
// else by what the user says.
#pragma once
#include <mrpt/poses/CPose3D.h>

#include <optional>

#include "ariadne/io/ros_options.h"
#include "survey.h"

namespace ariadne::io::ros {

struct Laser {
  std::string label;  ///< the topic; "topic:frame" where several frames share it
  std::size_t scans = 0;
  std::optional<mrpt::poses::CPose3D> robot_from_laser;
};

struct Choice {
  std::map<Survey::LaserKey, Laser> lasers;
  const OdometrySource* odometry = nullptr;  ///< of the survey
  std::string laser;                         ///< label of the one that is wanted
  std::vector<std::string> notes;            ///< what was chosen, for the user to see
  std::string why_not;                       ///< why nothing can be mapped; empty: it can
};

/// @param format what the recording is called in messages
Choice choose(const Survey& survey, const RosOptions& options, const std::string& format);

}  // namespace ariadne::io::ros
