#include "ariadne/models/scan_odometry.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ariadne/geometry/pose.h"
#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/grid/insertion/scan_shape.h"

namespace ariadne::models {
namespace {

using mrpt::DEG2RAD;
using mrpt::math::TPose2D;

// Mean field under the endpoints below which a scan fits nowhere.
constexpr double kFits = 0.3;
// A scan enters the map after this motion; a map is left after that distance.
constexpr double kInsert_m = 0.1;
constexpr double kInsert_rad = 0.1;
constexpr double kForget_m = 5;
constexpr double kGoesOn_s = 1;

/// A robot may turn by a good deal from one scan to the next and is known to within little else.
MatcherParams wide(MatcherParams params) {
  params.search_angle_deg = 30;
  params.search_distance_m = 0.5;
  params.search_below = 0.8;
  return params;
}

const Eigen::Matrix3d kPrior = Eigen::Vector3d(0.15, 0.15, DEG2RAD(10.0)).cwiseAbs2().asDiagonal();

}  // namespace

ScanOdometry::ScanOdometry(const grid::GridParams& grid, const MatcherParams& matcher, double gain)
    : grid_(grid),
      max_beams_(static_cast<std::size_t>(matcher.max_beams)),
      matcher_(wide(matcher), gain),
      map_(grid),
      next_(grid) {}

TPose2D ScanOdometry::predicted(double time_s) const {
  const double span_s = time_s - time_s_;
  if (motion_s_ <= 0 || span_s > kGoesOn_s) return pose_;
  const double share = std::clamp(span_s / motion_s_, 0.0, 2.0);
  return geometry::compose(pose_, {share * motion_.x, share * motion_.y, share * motion_.phi});
}

TPose2D ScanOdometry::add(const SensorStep& step) {
  if (!step.scan) return pose_;
  if (!started_) {
    started_ = true;
    time_s_ = step.time_s;
    insert(*step.scan);
    return pose_;
  }
  const TPose2D from = pose_;
  pose_ = predicted(step.time_s);
  const auto points =
      grid::thinned(grid::scanFeatures(*step.scan, grid_.insert_range_m, 1), max_beams_);
  const Match match = matcher_(map_, points, pose_, kPrior);
  if (match.score >= kFits)
    pose_ = match.map_from_robot;
  else
    ++lost_;
  motion_ = geometry::relativePose(from, pose_);
  motion_s_ = step.time_s - time_s_;
  time_s_ = step.time_s;
  const TPose2D motion = geometry::relativePose(inserted_, pose_);
  if (std::hypot(motion.x, motion.y) > kInsert_m || std::abs(motion.phi) > kInsert_rad)
    insert(*step.scan);
  return pose_;
}

void ScanOdometry::insert(const mrpt::obs::CObservation2DRangeScan& scan) {
  const TPose2D motion = geometry::relativePose(inserted_, pose_);
  next_m_ += std::hypot(motion.x, motion.y);
  if (next_m_ > kForget_m) {
    map_ = std::exchange(next_, grid::OccupancyGrid(grid_));
    next_m_ = 0;
  }
  const grid::ScanShape shape = grid::makeScanShape(scan, grid_);
  map_.insert(shape, pose_);
  next_.insert(shape, pose_);
  inserted_ = pose_;
}

}  // namespace ariadne::models
