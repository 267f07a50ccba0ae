// Parameters of the graph of places and of loop opportunities.
#pragma once
#include "ariadne/core/fields.h"

namespace ariadne::loops {

/// When a new place is made; keys of [loop_closing], explained in visitFields.
struct PlaceParams {
  double place_spacing_m = 2;
  double place_range_m = 6;
  double visit_radius_m = 1.5;
};

/// Bounds of Eq. (7); keys of [loop_closing], explained in visitFields.
struct OpportunityParams {
  double c1_m = 10;
  double c2_m = 25;
  double robot_radius_m = 0.2;
};

template <class V>
void visitFields(V& v, PlaceParams& p) {
  v.number(
      "place_spacing_m", p.place_spacing_m, {0.1, 100},
      "a place is made when the robot has travelled this distance since the last place it was at");
  v.number("place_range_m", p.place_range_m, {0.1, 100},
           "or when none is in line of sight within this distance");
  v.number("visit_radius_m", p.visit_radius_m, {0.05, 100},
           "the robot is at a place within this distance, in line of sight");
}

template <class V>
void visitFields(V& v, OpportunityParams& p) {
  v.number(
      "c1_m", p.c1_m, {0.1, 1000},
      "Eq. (7): a loop can be closed to a place nearer than this by the map; about the laser's "
      "range, since each metre later costs hypotheses");
  v.number("c2_m", p.c2_m, {0.1, 100000},
           "Eq. (7): and farther than this by the graph; more than c1_m");
  v.number("robot_radius_m", p.robot_radius_m, {0, 10},
           "paths through the map keep this far from walls and from the unknown");
}

/// Throws core::UsageError naming the key, also when c1 >= c2.
void validate(const OpportunityParams& params, const std::string& section);

}  // namespace ariadne::loops
