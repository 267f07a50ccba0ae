// What the log itself tells about its odometry: how far the steps that scans were matched on lie
// from those of the odometry. Starts as wide as [motion] says and narrows as matches come; learns
// what the odometry turns and stretches each metre as well (wheels larger than they are told). Uses
// s* alone, so that it is the same on any number of threads.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <array>
#include <cstddef>

#include "ariadne/models/offset_fit.h"
#include "ariadne/models/params.h"

namespace ariadne::models {

/// Fits how the odometry errs (scatter, stretch, turn) to what matches of scans found, by maximum
/// likelihood.
class MotionLearner {
 public:
  /// @param wide what is believed before anything is learned
  explicit MotionLearner(const MotionParams& wide);

  /// Takes a step whose scan was matched.
  /// @param increment of the odometry, m and rad, in the frame before the motion
  /// @param matched the same by the scan match
  /// @param before map_from_robot before the motion
  /// @param information of the scan about (x, y, heading), map frame: where it knows little (along
  /// a bare corridor) nothing is learned
  /// @param match_gain weight of the scan against the motion model in the match
  void add(const mrpt::math::TPose2D& increment, const mrpt::math::TPose2D& matched,
           const mrpt::math::TPose2D& before, const Eigen::Matrix3d& information,
           double match_gain);

  /// Standard deviations as learned.
  MotionParams params() const;
  /// The increment as the log's own matches would have it.
  mrpt::math::TPose2D corrected(const mrpt::math::TPose2D& increment) const;

  /// Shares of the [motion] given, along, across, turn; at most 1.
  std::array<double, 3> scales() const;
  /// Turn that the odometry lacks, rad per m.
  double turnPerMetre() const { return fits_[2].bias(); }
  /// Way that the odometry lacks, m per m.
  double stretch() const { return fits_[0].bias(); }
  /// Motions that it learned from.
  std::size_t steps() const { return steps_; }

 private:
  MotionParams wide_;
  std::array<OffsetFit, 3> fits_;  // along, across, turn
  std::size_t steps_ = 0;
};

}  // namespace ariadne::models
