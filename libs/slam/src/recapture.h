// Where a robot went while its odometry is in doubt: the scan is looked for in the map of one
// particle, wider than the filter's own matching does.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <Eigen/Dense>
#include <vector>

#include "ariadne/filter/particle.h"
#include "ariadne/models/params.h"
#include "dead_reckoning.h"

namespace ariadne::slam {

/// What is taken for the motion since the last update.
struct Recaptured {
  mrpt::math::TPose2D motion;
  Eigen::Matrix3d covariance;  ///< in the frame before the motion
  enum class By { scan, odometry, guess } by = By::guess;
};

class Recapture {
 public:
  /// @param gain as the filter's proposal_gain
  Recapture(const models::MatcherParams& matcher, double gain) : params_(matcher), gain_(gain) {}

  /// @param points that the scan is matched by, m, robot's frame
  /// @param expected motion since the last update
  Recaptured operator()(const filter::Particle& particle,
                        const std::vector<mrpt::math::TPoint2D>& points,
                        const mrpt::math::TPose2D& expected, const Doubt& doubt) const;

 private:
  models::MatcherParams params_;
  double gain_;
};

}  // namespace ariadne::slam
