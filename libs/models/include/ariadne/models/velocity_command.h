// What a robot with differential drive is told to do.
#pragma once

namespace ariadne::models {

struct VelocityCommand {
  double forward_m_s = 0;
  double turn_rad_s = 0;
};

}  // namespace ariadne::models
