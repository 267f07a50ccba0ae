#include "ariadne/models/odometry_jump.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "ariadne/geometry/pose.h"

namespace ariadne::models {
namespace {

using mrpt::DEG2RAD;
using mrpt::math::TPose2D;

constexpr std::size_t kRemembered = 50;
constexpr double kMoved_m = 0.01;
constexpr double kUsual = 5;  // times

bool isHome(const TPose2D& pose) {
  return std::hypot(pose.x, pose.y) < 0.1 &&
         std::abs(std::remainder(pose.phi, 2 * M_PI)) < DEG2RAD(3.0);
}

}  // namespace

std::optional<double> JumpDetector::usualStep_m() const {
  if (steps_m_.empty()) return std::nullopt;
  std::vector<double> steps(steps_m_.begin(), steps_m_.end());
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

bool JumpDetector::operator()(const TPose2D& odom_from_robot, double time_s) {
  const auto before = std::exchange(before_, Place{odom_from_robot, time_s});
  if (!before) return false;
  const TPose2D motion = geometry::relativePose(before->pose, odom_from_robot);
  const double distance_m = std::hypot(motion.x, motion.y);
  const double span_s = time_s - before->time_s;
  const double speed_m_s =
      span_s > 0 ? distance_m / span_s : std::numeric_limits<double>::infinity();
  const double rate = span_s > 0 ? std::abs(motion.phi) / span_s : 0;
  const bool home = isHome(odom_from_robot);
  const double turn = std::abs(motion.phi);
  if (turn > DEG2RAD(home ? 30.0 : 100.0) && rate > DEG2RAD(home ? 150.0 : 450.0)) return true;
  const auto usual_m = usualStep_m();
  // Over a gap in the log any distance is slow, so that of a reset the place alone tells.
  const double slowest_m_s = !home ? 5 : usual_m ? 0 : 2;
  if (distance_m > (home ? 0.5 : 1) && speed_m_s > slowest_m_s &&
      distance_m > (usual_m ? kUsual * *usual_m : 3))
    return true;
  if (distance_m > kMoved_m) steps_m_.push_back(distance_m);
  if (steps_m_.size() > kRemembered) steps_m_.pop_front();
  return false;
}

}  // namespace ariadne::models
