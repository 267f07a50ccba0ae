// Parameters of the motion model and the scan matcher.
#pragma once
#include "ariadne/core/fields.h"

namespace ariadne::models {

/// Odometry noise; it grows with the net turn (doc/explanation/models.md).
struct MotionParams {
  bool learn = true;
  double turn_per_turn = 0.3;
  double turn_per_m_deg = 5;
  double travel_per_m = 0.1;
  double travel_per_turn_m = 0.03;
  double side_per_m = 0.04;
  double turn_floor_deg = 0.2;
  double travel_floor_m = 0.005;
};

/// Scan matching.
struct MatcherParams {
  int max_beams = 180;
  int max_iterations = 12;
  double search_angle_deg = 12;
  double search_distance_m = 0.3;
  double sweep_below = 0.95;
  double search_below = 0.5;
  double disputed_sigmas = 4;
  double blind_share = 0.005;
};

template <class V>
void visitFields(V& v, MotionParams& p) {
  v.flag(
      "learn", p.learn,
      "narrow what follows by what scan matching says of this log's odometry, and learn how much "
      "it turns and stretches each metre");
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
  v.number("max_beams", p.max_beams, {10, 10000},
           "beams used for matching and weighing, thinned evenly");
  v.number("max_iterations", p.max_iterations, {1, 200}, "Gauss-Newton steps at the most");
  v.number("search_angle_deg", p.search_angle_deg, {0, 90},
           "coarse search about the predicted heading, half width; 0 for none");
  v.number("search_distance_m", p.search_distance_m, {0, 5},
           "coarse search about the predicted position, half width");
  v.number("sweep_below", p.sweep_below, {0, 1},
           "headings about the predicted one are tried when the mean field is under this");
  v.number("search_below", p.search_below, {0, 1},
           "the coarse search runs when the mean field under the endpoints is under this");
  v.number(
      "disputed_sigmas", p.disputed_sigmas, {0, 100},
      "a match this many standard deviations off the odometry is held against the scans of the "
      "last metres alone; 0: never");
  v.number("blind_share", p.blind_share, {0, 0.5},
           "where under this share of the walls stands across an axis, the odometry alone says how "
           "far the robot went along it, as in a bare corridor; 0: never");
}

}  // namespace ariadne::models
