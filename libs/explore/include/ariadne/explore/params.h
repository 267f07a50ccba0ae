// Parameters of exploration: the robot as it knows itself, and how it decides.
#pragma once
#include "ariadne/core/fields.h"

namespace ariadne::explore {

/// What the robot does about loops; which rule ends a closing and whether diversity is recovered
/// are set in the mapping's parameters to match, see applyStrategy().
enum class Strategy { frontier, active_uncertainty, active_neff, active_neff_recovery };

/// Which frontier is driven to; see `frontier_choice`.
enum class FrontierChoice { nearest, utility };

/// Section [explore]: each key's meaning and unit stand in visitFields.
struct ExploreParams {
  Strategy strategy = Strategy::active_neff_recovery;
  FrontierChoice frontier_choice = FrontierChoice::nearest;
  double gain_m_per_m = 1;
  double robot_radius_m = 0.2;
  double clearance_m = 0.08;
  double preferred_clearance_m = 0.5;
  double planning_cell_m = 0.1;
  double speed_m_s = 0.6;
  double turn_deg_s = 60;
  int giveup = 3;
  double max_laps = 2;
  double max_distance_m = 2000;
  double max_time_s = 7200;
  bool drive_home = false;
};

/// Their names in INIs and on the command line.
inline core::Choices<Strategy> strategies() {
  return {{"frontier", Strategy::frontier},
          {"active_uncertainty", Strategy::active_uncertainty},
          {"active_neff", Strategy::active_neff},
          {"active_neff_recovery", Strategy::active_neff_recovery}};
}

template <class V>
void visitFields(V& v, ExploreParams& p) {
  v.choice(
      "strategy", p.strategy, strategies(),
      "what is done about loops: frontier: nothing; active_uncertainty: a loop is closed until "
      "the pose is as certain as at the entry ([19] of the paper); active_neff: until Neff is "
      "constant; active_neff_recovery: the same, and diversity is recovered (the paper's)");
  v.choice("frontier_choice", p.frontier_choice,
           core::Choices<FrontierChoice>{{"nearest", FrontierChoice::nearest},
                                         {"utility", FrontierChoice::utility}},
           "which frontier is next: the one with the shortest route, or the one with the most "
           "gain_m_per_m * width - length of the route");
  v.number("gain_m_per_m", p.gain_m_per_m, {0, 1000},
           "metres of route that a metre of frontier is worth, for frontier_choice = utility");
  v.number("robot_radius_m", p.robot_radius_m, {0.05, 2}, "the robot is a disc");
  v.number("clearance_m", p.clearance_m, {0, 2},
           "planned routes keep this distance from walls, besides the radius");
  v.number("preferred_clearance_m", p.preferred_clearance_m, {0, 5},
           "and rather this distance, where a longer route allows it");
  v.number("planning_cell_m", p.planning_cell_m, {0.02, 1},
           "side of the planner's cells; a whole number of the map's is taken");
  v.number("speed_m_s", p.speed_m_s, {0.05, 5}, "speed on straights");
  v.number("turn_deg_s", p.turn_deg_s, {5, 360}, "fastest turn");
  v.number("giveup", p.giveup, {1, 100},
           "a goal is given up when the route to it was lost this often");
  v.number("max_laps", p.max_laps, {0.1, 1000},
           "a loop is left after this many times its length, whatever the stopping rule says");
  v.number("max_distance_m", p.max_distance_m, {1, 1e6}, "exploration ends after this distance");
  v.number("max_time_s", p.max_time_s, {1, 1e7}, "or this many seconds after the first scan");
  v.flag("drive_home", p.drive_home, "drive back to the start when nothing is left to explore");
}

}  // namespace ariadne::explore
