// How far a recovered particle set is from the true one: Kullback-Leibler divergence between two
// weighted sets of poses through kernel densities, and the mass that was lost.
//
// The paper (Section V) reports 1.0 to 1.5 for recovered sets and about 13 for a single survivor
// but neither the density estimate nor the floor; these figures are ours and compare with
// themselves.
#pragma once
#include "ariadne/core/fields.h"
#include "ariadne/geometry/weighted_poses.h"

namespace ariadne::eval {

/// The kernel that makes a density of weighted poses, and where such a density ends.
struct KernelParams {
  double bandwidth_m = 0.1;
  double heading_bandwidth_deg = 0;
  double floor_bandwidths = 5;
  double lost_bandwidths = 3;
};

template <class V>
void visitFields(V& v, KernelParams& p) {
  v.number("bandwidth_m", p.bandwidth_m, {0.001, 100},
           "standard deviation h of the density's kernel in x and y");
  v.number("heading_bandwidth_deg", p.heading_bandwidth_deg, {0, 60},
           "standard deviation of the kernel in heading; 0 leaves headings out");
  v.number("floor_bandwidths", p.floor_bandwidths, {1, 30},
           "densities under that of one kernel at this many bandwidths count as that");
  v.number("lost_bandwidths", p.lost_bandwidths, {0.1, 30},
           "a sample without another within this many bandwidths is lost");
}

/// How far two weighted sets of poses are apart, and for which share of them that is a guess.
struct Divergence {
  double kl_nats = 0;       ///< KL(p || q), estimated; may be slightly under 0
  double lost_mass = 0;     ///< weight of p's samples with no sample of q near, 0 to 1
  double floored_mass = 0;  ///< weight of p's samples at which q's density took the floor, 0 to 1
};

/// KL(p || q) = sum_i w_i ln(max(p(x_i), f) / max(q(x_i), f)) over p's samples x_i, where
///   p(x) = sum_j w_j K(d(x, x_j)),  d^2 = |dx, dy|^2 / h^2 + dheading^2 / h_heading^2,
///   K(d) = exp(-d^2 / 2) / (2 pi h^2)  (times 1 / (sqrt(2 pi) h_heading) with headings),
///   f = K(floor_bandwidths).
/// The floor is on both so that equal sets give exactly 0; with it KL is at most
/// floor_bandwidths^2 / 2, 12.5 nats by default. p's own samples are in p, which adds about
/// 1 / (N_p h^2 p(x)) / (2 pi): take sets of one size where sets are compared.
/// lost_mass: d > lost_bandwidths to every sample of q that has weight. Time grows with N_p N_q.
/// Throws core::Error for sets that are not normalised, core::UsageError for parameters.
Divergence divergence(const geometry::WeightedPoses& p, const geometry::WeightedPoses& q,
                      const KernelParams& params = {});

}  // namespace ariadne::eval
