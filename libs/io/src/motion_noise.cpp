#include "ariadne/io/motion_noise.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "ariadne/core/error.h"
#include "ariadne/core/random.h"

namespace ariadne::io {

void validate(const MotionNoise& noise) {
  const std::array<std::pair<const char*, double>, 4> fields = {{{"rot-rot", noise.rot_rot},
                                                                 {"rot-trans", noise.rot_trans},
                                                                 {"trans-trans", noise.trans_trans},
                                                                 {"trans-rot", noise.trans_rot}}};
  for (const auto& [name, value] : fields)
    if (!(value >= 0 && value <= 10))
      throw core::UsageError(fmt::format("{} is {}, must be 0 to 10", name, value));
}

mrpt::math::TPose2D NoisyOdometry::add(const mrpt::math::TPose2D& odom_from_robot) {
  if (!clean_) {
    clean_ = odom_from_robot;
    return noisy_ = odom_from_robot;
  }
  mrpt::math::TPose2D motion = odom_from_robot - *clean_;  // in the robot's frame
  clean_ = odom_from_robot;
  const double turn = std::abs(std::remainder(motion.phi, 2 * M_PI));
  const double distance = std::hypot(motion.x, motion.y);
  core::RandomStream random(seed_, count_++, 0, core::Purpose::noise);
  const double sigma_rot = noise_.rot_rot * turn + noise_.rot_trans * distance;
  const double sigma_trans = noise_.trans_trans * distance + noise_.trans_rot * turn;
  motion.phi += sigma_rot * random.gaussian();
  motion.x += sigma_trans * random.gaussian();
  motion.y += sigma_trans * random.gaussian();
  noisy_ = noisy_ + motion;
  noisy_.phi = std::remainder(noisy_.phi, 2 * M_PI);
  return noisy_;
}

}  // namespace ariadne::io
