#include "ariadne/explore/bumper.h"

#include <cmath>

namespace ariadne::explore {

void Bumper::touch(const mrpt::math::TPose2D& pose) {
  ++touches_;
  for (int degrees = -40; degrees <= 40; degrees += 10) {
    const double angle = pose.phi + degrees * M_PI / 180;
    points_.emplace_back(pose.x + rim_m_ * std::cos(angle), pose.y + rim_m_ * std::sin(angle));
  }
}

}  // namespace ariadne::explore
