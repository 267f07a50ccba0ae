// Parameters of a simulated drive: the robot as it truly moves and sees, and what its sensors add.
#pragma once
#include "ariadne/core/fields.h"

namespace ariadne::sim {

/// The robot, its laser (at its centre, looking ahead) and how it drives.
struct DriveParams {
  double speed_m_s = 0.6;
  double turn_deg_s = 60;
  double robot_radius_m = 0.2;
  double scan_rate_hz = 5;
  int beams = 181;
  double field_of_view_deg = 180;
  double max_range_m = 20;
};

/// Noise of odometry and ranges. Variances, not deviations, grow with the distance, so that it
/// makes no difference how many increments a drive is cut into: after L metres the standard
/// deviation of the distance is travel_per_root_m sqrt(L).
struct NoiseParams {
  double turn_per_root_turn = 0.05;
  double turn_per_root_m_deg = 0.5;
  double travel_per_root_m = 0.05;
  double side_per_root_m = 0.02;
  double range_sigma_m = 0.01;
};

template <class V>
void visitFields(V& v, DriveParams& p) {
  v.number("speed_m_s", p.speed_m_s, {0.05, 5}, "speed on straights");
  v.number("turn_deg_s", p.turn_deg_s, {5, 360}, "fastest turn");
  v.number("robot_radius_m", p.robot_radius_m, {0.05, 2}, "the robot is a disc; it must not touch");
  v.number("scan_rate_hz", p.scan_rate_hz, {0.2, 50}, "scans a second");
  v.number("beams", p.beams, {2, 10000}, "beams of a scan");
  v.number("field_of_view_deg", p.field_of_view_deg, {1, 360}, "from the first beam to the last");
  v.number("max_range_m", p.max_range_m, {0.5, 200}, "walls beyond it give no return");
}

template <class V>
void visitFields(V& v, NoiseParams& p) {
  v.number("turn_per_root_turn", p.turn_per_root_turn, {0, 2},
           "standard deviation of the heading, rad per sqrt(rad) turned");
  v.number("turn_per_root_m_deg", p.turn_per_root_m_deg, {0, 90},
           "standard deviation of the heading, degrees per sqrt(m) travelled");
  v.number("travel_per_root_m", p.travel_per_root_m, {0, 2},
           "standard deviation of the distance, m per sqrt(m) travelled");
  v.number("side_per_root_m", p.side_per_root_m, {0, 2},
           "standard deviation across the direction of travel, m per sqrt(m)");
  v.number("range_sigma_m", p.range_sigma_m, {0, 1}, "standard deviation of a range");
}

/// Both, as sections of a configuration.
struct SimParams {
  DriveParams drive;
  NoiseParams noise;
};

/// Calls f(section name, parameter struct) for each section.
template <class Params, class F>
void forEachSection(Params& params, F&& f) {
  f("drive", params.drive);
  f("noise", params.noise);
}

}  // namespace ariadne::sim
