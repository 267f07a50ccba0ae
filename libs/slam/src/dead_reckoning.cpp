#include "dead_reckoning.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/covariance.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/models/motion_model.h"

namespace ariadne::slam {
namespace {

using mrpt::math::TPose2D;

// Over a longer time nobody knows whether a robot went on as before.
constexpr double kGoesOn_s = 1;
// The motion model holds for ways between updates; longer ones are added up from parts.
constexpr double kPart_m = 1;
constexpr double kPart_rad = M_PI / 3;

TPose2D inverse(const TPose2D& pose) { return geometry::relativePose(pose, {0, 0, 0}); }

}  // namespace

TPose2D DeadReckoning::throughJump(double time_s) const {
  const double span_s = time_s - last_->time_s;
  if (!(span_s >= 0 && span_s <= kGoesOn_s && last_motion_s_ > 0)) return here_;
  const double share = std::min(span_s / last_motion_s_, 2.0);
  return geometry::compose(
      here_, {share * last_motion_.x, share * last_motion_.y, share * last_motion_.phi});
}

TPose2D DeadReckoning::add(const models::SensorStep& step) {
  const bool first = !last_;
  const TPose2D before = here_;
  if (first || !step.odometry_jumped) {
    here_ = corrected_ ? geometry::compose(here_from_odom_, step.odom_from_robot)
                       : step.odom_from_robot;
    if (!first) {
      last_motion_ = geometry::relativePose(before, here_);
      last_motion_s_ = step.time_s - last_->time_s;
    }
  } else {
    if (!doubt_) doubt_.emplace();
    const TPose2D claimed = geometry::relativePose(last_->odom_from_robot, step.odom_from_robot);
    doubt_->claimed = geometry::compose(sinceUpdate(), claimed);
    doubt_->gap_s = std::max(doubt_->gap_s, step.time_s - last_->time_s);
    here_ = throughJump(step.time_s);
    corrected_ = true;
    here_from_odom_ = geometry::compose(here_, inverse(step.odom_from_robot));
  }
  last_ = step;
  last_->scan.reset();
  return here_;
}

void DeadReckoning::passBlind() {
  const TPose2D motion = geometry::relativePose(at_part_, here_);
  if (std::hypot(motion.x, motion.y) < kPart_m && std::abs(motion.phi) < kPart_rad) return;
  if (!doubt_) doubt_.emplace();
  const Eigen::Matrix3d of_motion = models::Motion(motion, motion_).covariance({0, 0, 0});
  doubt_->covariance = geometry::composedCovariance(geometry::relativePose(at_update_, at_part_),
                                                    doubt_->covariance, motion, of_motion);
  doubt_->blind = true;
  at_part_ = here_;
}

void DeadReckoning::update(const TPose2D& here) {
  if (!(here == here_)) {
    corrected_ = true;
    here_ = here;
    here_from_odom_ = geometry::compose(here, inverse(last_->odom_from_robot));
  }
  at_update_ = at_part_ = here_;
  doubt_.reset();
}

TPose2D DeadReckoning::sinceUpdate() const { return geometry::relativePose(at_update_, here_); }
TPose2D DeadReckoning::afterUpdate(const TPose2D& motion) const {
  return geometry::compose(at_update_, motion);
}

}  // namespace ariadne::slam
