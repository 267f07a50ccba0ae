// How far odometry is off in one direction, from scan matches: a constant share of the distance
// (bias) and a scatter, by maximum likelihood over the last steps.
#pragma once
#include <cstddef>
#include <vector>

namespace ariadne::models {

/// What a scan says of one step of the odometry, without the odometry's own say.
struct Innovation {
  double off;             ///< from the odometry's step, m or rad
  double travel_m;        ///< of the step
  double variance_wide;   ///< of the odometry as given
  double variance_match;  ///< of the match: large where the scan says little
};

/// Fits scatter and bias of one component of the odometry's error, which grow with the motion.
class OffsetFit {
 public:
  /// @param sigma_per_m width of the bias before anything is known, per metre; 0: there is none
  explicit OffsetFit(double sigma_per_m) : bias_sigma_(sigma_per_m) {}

  /// Takes a step: off ~ N(bias travel, scale^2 variance_wide + variance_match). Expectation
  /// maximisation from where the last step left it; offsets over 2.5 standard deviations (slips,
  /// wrong matches) count as 2.5. Steps of which the scan says nothing change nothing.
  void add(const Innovation& step);

  /// Share of the given standard deviation.
  double scale() const;
  /// Per unit of motion.
  double bias() const { return bias_; }

 private:
  double bias_sigma_;
  std::vector<Innovation> last_;
  std::size_t next_ = 0;
  double scale2_ = 1;
  double bias_ = 0;
};

}  // namespace ariadne::models
