// All parameters of a mapping run; each struct is a section of the INI.
#pragma once
#include "ariadne/core/fields.h"
#include "ariadne/filter/params.h"
#include "ariadne/grid/params.h"
#include "ariadne/loops/closing/params.h"
#include "ariadne/loops/recovery/params.h"
#include "ariadne/models/params.h"

namespace ariadne::slam {

/// When the filter acts.
struct UpdateParams {
  double update_distance_m = 0.3;
  double update_angle_deg = 15;
  double least_returns = 0.1;
  int checkpoint_updates = 100;
};

template <class V>
void visitFields(V& v, UpdateParams& p) {
  v.number("update_distance_m", p.update_distance_m, {0, 100},
           "the filter is updated each time the robot has travelled this distance");
  v.number("update_angle_deg", p.update_angle_deg, {0, 180}, "or has turned by this angle");
  v.number("least_returns", p.least_returns, {0, 1},
           "but only by a scan of which this share of the beams returned within [grid] "
           "insert_range_m; where nothing is seen the pose follows the odometry");
  v.number("checkpoint_updates", p.checkpoint_updates, {1, 100000},
           "each time after this many updates every particle keeps its map as it is then "
           "(copy-on-write)");
}

/// All parameters of the filter; each struct is a section of the INI.
struct SlamParams {
  filter::FilterParams filter;
  UpdateParams update;
  grid::GridParams grid;
  grid::LikelihoodParams likelihood;
  models::MotionParams motion;
  models::MatcherParams matcher;
  loops::ClosingParams loop_closing;
  loops::RecoveryParams recovery;
};

/// Calls f(section name, parameter struct) for each section.
template <class Params, class F>
void forEachSection(Params& params, F&& f) {
  f("filter", params.filter);
  f("update", params.update);
  f("grid", params.grid);
  f("likelihood", params.likelihood);
  f("motion", params.motion);
  f("matcher", params.matcher);
  f("loop_closing", params.loop_closing);
  f("recovery", params.recovery);
}

}  // namespace ariadne::slam
