// Noise for the odometry of a recorded log. Its spread grows with the net turn and the distance of
// an increment, not with the two rotations of rotation-translation-rotation: turning almost in
// place both of those are near 90 degrees, and so would be the noise.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <optional>

namespace ariadne::io {

/// How much noise is made per motion, as the odometry model of Thrun et al. 2005, Section 5.4 has
/// it.
struct MotionNoise {
  double rot_rot = 0.05;      ///< rad of heading noise per rad turned
  double rot_trans = 0.01;    ///< rad of heading noise per m travelled
  double trans_trans = 0.05;  ///< m of position noise per m travelled
  double trans_rot = 0.01;    ///< m of position noise per rad turned
};

/// Throws core::UsageError unless all are finite, not negative and at most 10.
void validate(const MotionNoise& noise);

/// sigma_rot = rot_rot |turn| + rot_trans distance, sigma_trans = trans_trans distance + trans_rot
/// |turn|; heading, x and y of each increment get independent Gaussian noise. The k-th increment's
/// draw depends on (seed, k) only.
class NoisyOdometry {
 public:
  /// The same seed gives the same noise.
  NoisyOdometry(const MotionNoise& noise, std::uint64_t seed) : noise_(noise), seed_(seed) {}
  /// The noisy pose for the next clean one; the first is kept as it is.
  mrpt::math::TPose2D add(const mrpt::math::TPose2D& odom_from_robot);

 private:
  MotionNoise noise_;
  std::uint64_t seed_;
  std::uint32_t count_ = 0;
  std::optional<mrpt::math::TPose2D> clean_;
  mrpt::math::TPose2D noisy_;
};

}  // namespace ariadne::io
