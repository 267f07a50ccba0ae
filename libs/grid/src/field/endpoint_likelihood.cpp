#include "ariadne/grid/field/endpoint_likelihood.h"

#include <cmath>

#include "ariadne/grid/field/field_batch.h"
#include "ariadne/grid/field/field_sampler.h"

namespace ariadne::grid {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

std::vector<TPoint2D> thinned(const std::vector<TPoint2D>& points, std::size_t count) {
  if (points.size() <= count) return points;
  std::vector<TPoint2D> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = points[i * points.size() / count];
  return out;
}

EndpointLikelihood::EndpointLikelihood(const LikelihoodParams& params, double field_sigma_m)
    : hit_weight_(params.hit_weight),
      // field = 255 exp(-d^2 / 2 f^2), so exp(-d^2 / 2 sigma^2) = (field / 255)^(f^2 / sigma^2).
      exponent_(std::pow(field_sigma_m / params.hit_sigma_m, 2)),
      field_sigma_m_(field_sigma_m),
      hit_sigma_m_(params.hit_sigma_m) {
  for (int i = 0; i <= 255; ++i) {
    const double density = hit_weight_ * std::pow(i / 255.0, exponent_);
    table_[i] = std::log(density + 1 - hit_weight_);
    slope_[i] = i == 0 ? 0 : exponent_ * density / (i / 255.0 * (density + 1 - hit_weight_));
  }
  table_[256] = table_[255];
  unknown_ = params.unknown_share * table_[0];
}

double EndpointLikelihood::operator()(const OccupancyGrid& map, const std::vector<TPoint2D>& points,
                                      const TPose2D& map_from_robot) const {
  if (points.empty()) return 0;
  FieldSampler field(map);
  const double c = std::cos(map_from_robot.phi);
  const double s = std::sin(map_from_robot.phi);
  double sum = 0;
  for (const TPoint2D& p : points) {
    const double x = map_from_robot.x + c * p.x - s * p.y;
    const double y = map_from_robot.y + s * p.x + c * p.y;
    const double value = field.value(x, y);
    sum += value > 0 || map.at(map.cellOf({x, y})) != 0 ? beam(value) : unknown_;
  }
  return sum * (kNominalBeams / static_cast<double>(points.size()));
}

Eigen::Matrix3d EndpointLikelihood::information(const OccupancyGrid& map,
                                                const std::vector<TPoint2D>& points,
                                                const TPose2D& map_from_robot) const {
  if (points.empty()) return Eigen::Matrix3d::Zero();
  double xx = 0, xy = 0, xt = 0, yy = 0, yt = 0, tt = 0;
  static thread_local FieldBatch field;
  field.use(map, points);
  field.turn(map_from_robot.phi);
  const double* rx = field.offsetX();
  const double* ry = field.offsetY();
  const double h = field_sigma_m_;
  constexpr int kSides[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (const auto& side : kSides) {
    field.sample({map_from_robot.x + side[0] * h, map_from_robot.y + side[1] * h});
    for (std::size_t i = 0; i < field.size(); ++i) {
      const double slope = slope_[static_cast<int>(field.value()[i] * 255)];
      const double gx = slope * field.dx()[i];
      const double gy = slope * field.dy()[i];
      const double gt = gy * rx[i] - gx * ry[i];
      xx += gx * gx;
      xy += gx * gy;
      xt += gx * gt;
      yy += gy * gy;
      yt += gy * gt;
      tt += gt * gt;
    }
  }
  Eigen::Matrix3d sum;
  sum << xx, xy, xt, xy, yy, yt, xt, yt, tt;
  // Two sides an axis; at distance h a beam's gradient is h / sigma^2, the information 1 / sigma^2.
  return sum *
         (0.5 * std::pow(hit_sigma_m_ / h, 2) * kNominalBeams / static_cast<double>(points.size()));
}

}  // namespace ariadne::grid
