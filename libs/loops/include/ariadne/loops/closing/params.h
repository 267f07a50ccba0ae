// Parameters of closing a loop.
#pragma once
#include "ariadne/core/fields.h"
#include "ariadne/loops/places/params.h"

namespace ariadne::loops {

/// When a closing ends, besides when the robot leaves what it knew.
enum class Stop { leaving, neff, neff_slope, uncertainty, path_end, laps, never };

/// Section [loop_closing]; each key is explained in visitFields.
struct ClosingParams {
  bool enabled = true;
  PlaceParams places;
  OpportunityParams opportunity;
  double approach_limit_m = 30;
  double leave_after_m = 4;
  double cooldown_m = 5;
  bool search = true;
  double search_window_m = 10;
  Stop stop = Stop::leaving;
  double arm_distance_m = 5;
  double neff_window_m = 10;
  double neff_change = 0.1;
  double neff_slope_per_m = 0.01;
  int laps = 1;
};

template <class V>
void visitFields(V& v, ClosingParams& p) {
  v.flag("enabled", p.enabled, "watch for loops, and recover diversity after closing one");
  visitFields(v, p.places);
  visitFields(v, p.opportunity);
  v.number("approach_limit_m", p.approach_limit_m, {0.1, 100000},
           "an opportunity is given up when the robot has driven this distance and has not come to "
           "its entry");
  v.number("leave_after_m", p.leave_after_m, {0.1, 1000},
           "the closing ends when the robot has driven this distance without coming to a place "
           "that it knew before");
  v.number("cooldown_m", p.cooldown_m, {0, 10000},
           "no loop is looked for within this distance after a closing");
  v.flag(
      "search", p.search,
      "look for the place where the loop should close, from metres away, and draw the path since "
      "given it; "
      "false is the paper's filter");
  v.number("search_window_m", p.search_window_m, {0.5, 30},
           "a place is looked for this far from where the robot should be, at the most");
  v.choice(
      "stop", p.stop,
      core::Choices<Stop>{{"leaving", Stop::leaving},
                          {"neff", Stop::neff},
                          {"neff_slope", Stop::neff_slope},
                          {"uncertainty", Stop::uncertainty},
                          {"path_end", Stop::path_end},
                          {"laps", Stop::laps},
                          {"never", Stop::never}},
      "what ends a closing besides leaving the loop: leaving: nothing; neff: Neff is constant (the "
      "paper's rule); neff_slope: Neff does not fall between resamplings; uncertainty: the pose is "
      "as certain as at the entry ([19] of the paper); path_end: the loop's length is driven; "
      "laps: its length is driven this often. With never, leaving the loop does not end it either");
  v.number("arm_distance_m", p.arm_distance_m, {0, 100000},
           "stop = uncertainty waits for this distance after the entry; the rules on Neff wait for "
           "their window");
  v.number("neff_window_m", p.neff_window_m, {0.1, 100000},
           "Neff is judged over this distance, all of it after the entry");
  v.number("neff_change", p.neff_change, {0, 1},
           "Neff is constant when it changes by less than this share of N over the window");
  v.number("neff_slope_per_m", p.neff_slope_per_m, {0, 100},
           "ln Neff is flat when it falls by less than this per metre, resamplings left out");
  v.number("laps", p.laps, {1, 100000}, "number of laps of the loop, for stop = laps");
}

/// Throws core::UsageError naming the key, also when c1_m >= c2_m.
void validate(const ClosingParams& params, const std::string& section);

}  // namespace ariadne::loops
