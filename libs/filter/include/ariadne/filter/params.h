// Parameters of the mapping filter, with defaults, units and bounds; free of any file format.
#pragma once
#include <cstdint>

#include "ariadne/core/fields.h"

namespace ariadne::filter {

/// Where a particle's next pose is drawn; see `proposal`.
enum class Proposal { odometry, scan_match, improved };
/// MRPT's four methods; see `resampling`.
enum class Resampling { multinomial, residual, stratified, systematic };

/// Section [filter]; each key is explained in visitFields.
struct FilterParams {
  int particles = 30;
  std::uint64_t seed = 1;
  Proposal proposal = Proposal::improved;
  double proposal_gain = 8;
  double weight_gain = 0.05;
  double new_ground_weight = 1;
  double revisit_exponent = 2;
  double revisit_radius_m = 2;
  double beta = 0.5;
  Resampling resampling = Resampling::systematic;
};

template <class V>
void visitFields(V& v, FilterParams& p) {
  v.number("particles", p.particles, {1, 100000}, "number of particles N");
  v.number("seed", p.seed, {0, 9007199254740992.0},
           "same seed, same bits, on any number of threads");
  v.choice(
      "proposal", p.proposal,
      core::Choices<Proposal>{{"odometry", Proposal::odometry},
                              {"scan_match", Proposal::scan_match},
                              {"improved", Proposal::improved}},
      "where new poses are drawn: the motion model; the matched pose itself; a Gaussian fitted "
      "to motion model times likelihood about it");
  v.number("proposal_gain", p.proposal_gain, {0.0001, 1000},
           "tempering of the scan's log likelihood (per 180 beams' mean) in the proposal; higher "
           "is narrower");
  v.number(
      "weight_gain", p.weight_gain, {0.00001, 1000},
      "tempering of the scan's log likelihood in the weights: beams are not independent witnesses");
  v.number("new_ground_weight", p.new_ground_weight, {0, 1},
           "a scan weighs this much where the robot was not before: its own map of a moment ago "
           "tells hypotheses apart by chance only; 1 is the plain filter");
  v.number("revisit_exponent", p.revisit_exponent, {0, 10},
           "the r-th revisit of a place weighs 1/r^exponent; 0 is the plain filter");
  v.number("revisit_radius_m", p.revisit_radius_m, {0.1, 100},
           "within this distance of an earlier pass the robot revisits");
  v.number("beta", p.beta, {0, 1}, "resample when Neff, Eq. (10), is under beta N");
  v.choice("resampling", p.resampling,
           core::Choices<Resampling>{{"multinomial", Resampling::multinomial},
                                     {"residual", Resampling::residual},
                                     {"stratified", Resampling::stratified},
                                     {"systematic", Resampling::systematic}},
           "MRPT's resampling methods");
}

}  // namespace ariadne::filter
