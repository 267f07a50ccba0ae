// Parameters of the occupancy grid.
#pragma once
#include "ariadne/core/fields.h"

namespace ariadne::grid {

/// The grid, and how scans enter it.
struct GridParams {
  double resolution_m = 0.05;
  double insert_range_m = 30;
  double free_probability = 0.65;
  double occupied_probability = 0.9;
  double no_return_free_m = 0;
  double field_sigma_m = 0.07;
};

/// How well a scan fits a map, beam by beam.
struct LikelihoodParams {
  double hit_sigma_m = 0.1;
  double hit_weight = 0.9;
  double unknown_share = 0.3;
};

template <class V>
void visitFields(V& v, GridParams& p) {
  v.number("resolution_m", p.resolution_m, {0.005, 2}, "side of a grid cell");
  v.number("insert_range_m", p.insert_range_m, {0.5, 500},
           "beams are inserted into the map up to this range; longer ones clear up to it");
  v.number("free_probability", p.free_probability, {0.51, 0.99},
           "probability that a cell a beam passed is free");
  v.number("occupied_probability", p.occupied_probability, {0.51, 0.99},
           "probability that a cell a beam ended in is occupied");
  v.number("no_return_free_m", p.no_return_free_m, {0, 500},
           "a beam without return clears up to this range; 0 ignores it");
  v.number("field_sigma_m", p.field_sigma_m, {0.01, 2},
           "width of the likelihood field about occupied cells that scans are matched on; wider "
           "pulls from farther");
}

template <class V>
void visitFields(V& v, LikelihoodParams& p) {
  v.number("hit_sigma_m", p.hit_sigma_m, {0.01, 2},
           "standard deviation of an endpoint's distance to the nearest occupied cell");
  v.number("hit_weight", p.hit_weight, {0.01, 0.999},
           "share of beams expected to end on something mapped");
  v.number("unknown_share", p.unknown_share, {0, 1},
           "an endpoint in unknown space costs this share of one in free space");
}

}  // namespace ariadne::grid
