// What a robot with differential drive is told to do.
#pragma once

namespace ariadne::models {

/// What a robot is told to do until the next command.
struct VelocityCommand {
  double forward_m_s = 0;
  double turn_rad_s = 0;
};

}  // namespace ariadne::models
