// Parameters of the mapping filter, with defaults, units and bounds; free of any file format.
#pragma once
#include <cstdint>

#include "ariadne/core/fields.h"

namespace ariadne::filter {

enum class Proposal { odometry, scan_match, improved };
enum class Resampling { multinomial, residual, stratified, systematic };

/// When the filter acts, and on what grid.
struct MappingParams {
  double resolution_m = 0.05;
  double insert_range_m = 30;
  double free_probability = 0.6;
  double occupied_probability = 0.9;
  double no_return_free_m = 0;
  double update_distance_m = 0.3;
  double update_angle_deg = 15;
  int checkpoint_updates = 10;
};

/// Odometry noise, rotation-translation-rotation; grows with the net turn (doc/models.md).
struct MotionParams {
  double turn_per_turn = 0.1;
  double turn_per_m_deg = 2;
  double travel_per_m = 0.1;
  double travel_per_turn_m = 0.03;
  double side_per_m = 0.04;
  double turn_floor_deg = 0.2;
  double travel_floor_m = 0.005;
};

/// Scan matching and the likelihood of endpoints.
struct MatcherParams {
  double field_sigma_m = 0.12;
  int max_beams = 180;
  int max_iterations = 12;
  double search_angle_deg = 12;
  double search_distance_m = 0.3;
  double hit_sigma_m = 0.1;
  double hit_weight = 0.9;
};

struct FilterParams {
  int particles = 30;
  std::uint64_t seed = 1;
  Proposal proposal = Proposal::improved;
  double proposal_gain = 2;
  double weight_gain = 0.05;
  double revisit_exponent = 2;
  double revisit_radius_m = 2;
  double beta = 0.5;
  Resampling resampling = Resampling::systematic;
};

template <class V>
void visitFields(V& v, MappingParams& p) {
  v.number("resolution_m", p.resolution_m, {0.005, 2}, "side of a grid cell");
  v.number("insert_range_m", p.insert_range_m, {0.5, 500},
           "beams are inserted into the map up to this range; longer ones clear up to it");
  v.number("free_probability", p.free_probability, {0.51, 0.99},
           "probability that a cell a beam passed is free");
  v.number("occupied_probability", p.occupied_probability, {0.51, 0.99},
           "probability that a cell a beam ended in is occupied");
  v.number("no_return_free_m", p.no_return_free_m, {0, 500},
           "a beam without return clears up to this range; 0 ignores it");
  v.number("update_distance_m", p.update_distance_m, {0, 100},
           "the filter is updated each time the robot has travelled so far");
  v.number("update_angle_deg", p.update_angle_deg, {0, 180}, "or has turned so far");
  v.number("checkpoint_updates", p.checkpoint_updates, {1, 100000},
           "every particle keeps its map as of every so many updates (copy-on-write)");
}

template <class V>
void visitFields(V& v, MotionParams& p) {
  v.number("turn_per_turn", p.turn_per_turn, {0, 2},
           "standard deviation of the turn, rad per rad of net turn");
  v.number("turn_per_m_deg", p.turn_per_m_deg, {0, 90},
           "standard deviation of the turn, degrees per sqrt(m) travelled");
  v.number("travel_per_m", p.travel_per_m, {0, 2},
           "standard deviation of the distance, m per m travelled");
  v.number("travel_per_turn_m", p.travel_per_turn_m, {0, 2},
           "standard deviation of the distance, m per rad turned");
  v.number("side_per_m", p.side_per_m, {0, 2},
           "standard deviation across the direction of travel, m per m");
  v.number("turn_floor_deg", p.turn_floor_deg, {0.001, 90}, "least standard deviation of the turn");
  v.number("travel_floor_m", p.travel_floor_m, {0.0001, 10},
           "least standard deviation along and across");
}

template <class V>
void visitFields(V& v, MatcherParams& p) {
  v.number("field_sigma_m", p.field_sigma_m, {0.01, 2},
           "width of the likelihood field that the matcher climbs; wider pulls from farther");
  v.number("max_beams", p.max_beams, {10, 10000}, "beams used for matching and weighing, thinned evenly");
  v.number("max_iterations", p.max_iterations, {1, 200}, "Gauss-Newton steps at the most");
  v.number("search_angle_deg", p.search_angle_deg, {0, 90},
           "coarse search about the predicted heading, half width; 0 for none");
  v.number("search_distance_m", p.search_distance_m, {0, 5},
           "coarse search about the predicted position, half width");
  v.number("hit_sigma_m", p.hit_sigma_m, {0.01, 2},
           "standard deviation of an endpoint's distance to the nearest occupied cell");
  v.number("hit_weight", p.hit_weight, {0.01, 0.999},
           "share of beams expected to end on something mapped");
}

template <class V>
void visitFields(V& v, FilterParams& p) {
  v.number("particles", p.particles, {1, 100000}, "number of particles N");
  v.number("seed", p.seed, {0, 9007199254740992.0}, "same seed, same bits, on any number of threads");
  v.choice("proposal", p.proposal,
           core::Choices<Proposal>{{"odometry", Proposal::odometry},
                                   {"scan_match", Proposal::scan_match},
                                   {"improved", Proposal::improved}},
           "where new poses are drawn: the motion model; the matched pose itself; a Gaussian fitted "
           "to motion model times likelihood about it");
  v.number("proposal_gain", p.proposal_gain, {0.0001, 1000},
           "tempering of the scan's log likelihood (per 180 beams' mean) in the proposal; higher is narrower");
  v.number("weight_gain", p.weight_gain, {0.00001, 1000},
           "tempering of the scan's log likelihood in the weights: beams are not independent witnesses");
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
