// What the log itself tells about its odometry: how far the steps that scans were matched on lie
// from those of the odometry. Starts as wide as [motion] says and narrows as matches come; learns a
// constant turn per metre as well (a wheel that is larger than the other). Uses s* alone, so that
// it is the same on any number of threads.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <vector>

#include "ariadne/models/params.h"

namespace ariadne::models {

class MotionLearner {
 public:
  explicit MotionLearner(const MotionParams& wide) : wide_(wide) {}

  /// Takes a step whose scan was matched.
  /// @param increment of the odometry, m and rad, in the frame before the motion
  /// @param matched the same by the scan match
  /// @param before map_from_robot before the motion
  /// @param information of the scan about (x, y, heading), map frame: a direction in which the scan
  /// knows
  ///   little (along a bare corridor) says nothing about the odometry
  void add(const mrpt::math::TPose2D& increment, const mrpt::math::TPose2D& matched,
           const mrpt::math::TPose2D& before, const Eigen::Matrix3d& information);

  /// Standard deviations as learned.
  MotionParams params() const;
  /// The increment without the turn that the odometry adds per metre.
  mrpt::math::TPose2D corrected(const mrpt::math::TPose2D& increment) const;

  /// Shares of the [motion] given, along, across, turn; at most 1.
  std::array<double, 3> scales() const;
  /// Turn that the odometry lacks, rad per m.
  double turnPerMetre() const;
  std::size_t steps() const { return steps_; }

 private:
  /// The last values, of which the median is taken.
  class Window {
   public:
    void add(double value);
    std::size_t size() const { return values_.size(); }
    double median() const;

   private:
    std::vector<double> values_;
    std::size_t next_ = 0;
  };

  MotionParams wide_;
  std::array<Window, 3> off_;  // absolute residual over its standard deviation by wide_
  Window turn_per_m_;
  std::size_t steps_ = 0;
};

}  // namespace ariadne::models
