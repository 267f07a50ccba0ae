#include "ariadne/checks/drive_watch.h"

#include <cmath>

#include "ariadne/geometry/pose.h"
#include "ariadne/grid/insertion/scan_shape.h"

namespace ariadne::checks {
namespace {

// Below these the odometry stands still.
constexpr double kStill_m = 0.02;
constexpr double kStill_rad = 0.02;
// So long it may stand before the scans are asked, which takes time.
constexpr std::size_t kPatience = 3;
// And by the scans the robot has driven from here on.
constexpr double kDrove_m = 0.3;
constexpr double kDrove_rad = 0.26;
constexpr double kGain = 8;

bool within(const mrpt::math::TPose2D& motion, double distance_m, double angle_rad) {
  return std::hypot(motion.x, motion.y) < distance_m && std::abs(motion.phi) < angle_rad;
}

}  // namespace

void DriveWatch::add(const models::SensorStep& step) {
  if (!step.scan) return;
  const bool first = figures_.scans++ == 0;
  figures_.blind_scans += grid::isBlind(*step.scan, grid_, least_returns_);
  if (!first && !step.odometry_jumped)
    figures_.odometry_m += geometry::distance(step.odom_from_robot, last_);
  last_ = step.odom_from_robot;
  const auto motion = geometry::relativePose(stand_, step.odom_from_robot);
  if (first || !within(motion, kStill_m, kStill_rad)) {
    stand_ = step.odom_from_robot;
    still_ = 0;
    by_scans_.reset();
  } else {
    stand(step);
  }
}

void DriveWatch::stand(const models::SensorStep& step) {
  if (++still_ < kPatience) return;
  if (!by_scans_) by_scans_.emplace(grid_, models::MatcherParams(), kGain);
  figures_.standing_scans += !within(by_scans_->add(step), kDrove_m, kDrove_rad);
}

}  // namespace ariadne::checks
