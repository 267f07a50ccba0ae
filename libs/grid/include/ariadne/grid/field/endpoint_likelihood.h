// p(z | x, m) of a scan: each beam's endpoint is judged by its distance d to the nearest occupied
// cell, log(h exp(-d^2 / 2 sigma^2) + 1 - h) (likelihood field, Thrun et al., Probabilistic
// Robotics, 6.4). An endpoint in unknown space says nothing for or against and counts as a beam of
// middling quality.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/grid/params.h"

namespace ariadne::grid {

/// Scans count as if they had this many beams, however many they have; gains are per that.
constexpr double kNominalBeams = 180;

/// At most `count` of the points, evenly spaced, in their order.
std::vector<mrpt::math::TPoint2D> thinned(const std::vector<mrpt::math::TPoint2D>& points,
                                          std::size_t count);

/// How well the ends of a scan's beams fit the map, by what the likelihood field says there: a
/// Gaussian of the distance to the next wall, mixed with a uniform part (Thrun et al. 2005, Section
/// 6.4).
class EndpointLikelihood {
 public:
  /// @param field_sigma_m standard deviation that the field was made with, m
  EndpointLikelihood(const LikelihoodParams& params, double field_sigma_m);

  /// Log likelihood of the scan, scaled to kNominalBeams, untempered.
  /// @param points ends of beams, m, robot's frame.
  double operator()(const OccupancyGrid& map, const std::vector<mrpt::math::TPoint2D>& points,
                    const mrpt::math::TPose2D& map_from_robot) const;

  /// Fisher information of the scan about (x, y, heading) near a pose that maximises the
  /// likelihood: the sum of gradient times its transpose over beams, taken one field width to each
  /// side, since at the peak itself the gradients vanish. Always positive semidefinite; second
  /// differences are not, and a clamped one samples the motion model's noise into good matches.
  Eigen::Matrix3d information(const OccupancyGrid& map,
                              const std::vector<mrpt::math::TPoint2D>& points,
                              const mrpt::math::TPose2D& map_from_robot) const;

 private:
  double beam(double field) const {
    const int i = static_cast<int>(field);
    return table_[i] + (table_[i + 1] - table_[i]) * (field - i);
  }
  std::array<double, 257> table_;  // by field value, 0..255, and one more to interpolate
  std::array<double, 256> slope_;  // d log likelihood / d (field / 255)
  double unknown_;
  double hit_weight_;
  double exponent_;  // field^exponent is the hit density
  double field_sigma_m_;
  double hit_sigma_m_;
};

}  // namespace ariadne::grid
