#include "ariadne/eval/kl_divergence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ariadne::eval {
namespace {

/// Kernel density in units of the kernel's peak, which cancels in the ratio of two.
class Density {
 public:
  Density(const geometry::WeightedPoses& set, const KernelParams& params)
      : set_(set),
        per_m_(1 / params.bandwidth_m),
        per_rad_(params.heading_bandwidth_deg > 0 ? 180 / (M_PI * params.heading_bandwidth_deg)
                                                  : 0) {}

  struct Value {
    double density = 0;
    double nearest = std::numeric_limits<double>::infinity();  // bandwidths
  };
  Value at(const mrpt::math::TPose2D& x) const {
    Value v;
    double least = v.nearest;
    for (std::size_t j = 0; j < set_.poses.size(); ++j) {
      if (set_.weights[j] == 0) continue;
      const auto& y = set_.poses[j];
      const double dx = (x.x - y.x) * per_m_;
      const double dy = (x.y - y.y) * per_m_;
      const double turn = per_rad_ == 0 ? 0 : std::remainder(x.phi - y.phi, 2 * M_PI) * per_rad_;
      const double squared = dx * dx + dy * dy + turn * turn;
      v.density += set_.weights[j] * std::exp(-squared / 2);
      least = std::min(least, squared);
    }
    v.nearest = std::sqrt(least);
    return v;
  }

 private:
  const geometry::WeightedPoses& set_;
  double per_m_;
  double per_rad_;
};

}  // namespace

Divergence divergence(const geometry::WeightedPoses& p, const geometry::WeightedPoses& q,
                      const KernelParams& params) {
  core::validateFields(params, "kernel");
  geometry::checkWeightedPoses(p);
  geometry::checkWeightedPoses(q);
  const Density of_p(p, params);
  const Density of_q(q, params);
  const double floor = std::exp(-params.floor_bandwidths * params.floor_bandwidths / 2);
  Divergence d;
  for (std::size_t i = 0; i < p.poses.size(); ++i) {
    const double w = p.weights[i];
    if (w == 0) continue;
    const auto here = of_q.at(p.poses[i]);
    const double own = of_p.at(p.poses[i]).density;
    d.kl_nats += w * std::log(std::max(own, floor) / std::max(here.density, floor));
    if (here.nearest > params.lost_bandwidths) d.lost_mass += w;
    if (here.density < floor) d.floored_mass += w;
  }
  return d;
}

}  // namespace ariadne::eval
