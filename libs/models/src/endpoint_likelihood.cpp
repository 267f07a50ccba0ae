#include "ariadne/models/endpoint_likelihood.h"

#include <cmath>

#include "ariadne/grid/field_sampler.h"

namespace ariadne::models {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

std::vector<TPoint2D> thinned(const std::vector<TPoint2D>& points, std::size_t count) {
  if (points.size() <= count) return points;
  std::vector<TPoint2D> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = points[i * points.size() / count];
  return out;
}

EndpointLikelihood::EndpointLikelihood(const MatcherParams& params, double field_sigma_m) {
  // field = 255 exp(-d^2 / 2 f^2), so exp(-d^2 / 2 sigma^2) = (field / 255)^(f^2 / sigma^2).
  const double exponent = std::pow(field_sigma_m / params.hit_sigma_m, 2);
  for (int i = 0; i <= 255; ++i)
    table_[i] = std::log(params.hit_weight * std::pow(i / 255.0, exponent) + 1 - params.hit_weight);
  table_[256] = table_[255];
  unknown_ = params.unknown_share * table_[0];
}

double EndpointLikelihood::operator()(const grid::OccupancyGrid& map,
                                      const std::vector<TPoint2D>& points,
                                      const TPose2D& map_from_robot) const {
  if (points.empty()) return 0;
  grid::FieldSampler field(map);
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

}  // namespace ariadne::models
