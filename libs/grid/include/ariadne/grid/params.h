// Parameters of the occupancy grid.
#pragma once
#include "ariadne/core/fields.h"

namespace ariadne::grid {

/// The grid, and how scans enter it.
struct GridParams {
  double resolution_m = 0.05;
  double insert_range_m = 30;
  double free_probability = 0.6;
  double occupied_probability = 0.9;
  double no_return_free_m = 0;
  double field_sigma_m = 0.07;
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

}  // namespace ariadne::grid
