#include "ariadne/loops/closing/stop_rules.h"

#include <algorithm>
#include <cmath>

namespace ariadne::loops {
namespace {

/// First step of the last window_m; nothing when the course is shorter.
std::size_t windowStart(const ClosingCourse& course, double window_m) {
  const double from = course.steps.back().travelled_m - window_m;
  std::size_t i = course.steps.size();
  while (i > 0 && course.steps[i - 1].travelled_m >= from) --i;
  return i;
}

bool coversWindow(const ClosingCourse& course, double window_m) {
  return !course.steps.empty() && course.driven_m() >= window_m;
}

}  // namespace

double slopeOfLogNeff(const std::vector<ClosingStep>& steps, std::size_t first) {
  double change = 0;
  double path_m = 0;
  for (std::size_t i = first + 1; i < steps.size(); ++i) {
    if (steps[i - 1].resampled) {  // after it Neff starts at N
      change += std::log(steps[i].neff / steps[i].particles);
    } else {
      change += std::log(steps[i].neff / steps[i - 1].neff);
    }
    path_m += steps[i].travelled_m - steps[i - 1].travelled_m;
  }
  return path_m > 0 ? change / path_m : 0;
}

StopRule neffConstantFor(double window_m, double change) {
  return [=](const ClosingCourse& c) {
    if (!coversWindow(c, window_m)) return false;
    double low = c.steps.back().neff;
    double high = low;
    for (std::size_t i = windowStart(c, window_m); i < c.steps.size(); ++i) {
      if (c.steps[i].resampled) return false;
      low = std::min(low, c.steps[i].neff);
      high = std::max(high, c.steps[i].neff);
    }
    return high - low < change * c.steps.back().particles;
  };
}

StopRule neffFallsLessThan(double slope_per_m, double window_m) {
  return [=](const ClosingCourse& c) {
    return coversWindow(c, window_m) &&
           slopeOfLogNeff(c.steps, windowStart(c, window_m)) > -slope_per_m;
  };
}

StopRule uncertaintyBackToEntry() {
  return [](const ClosingCourse& c) {
    return !c.steps.empty() && c.steps.back().uncertainty_m <= c.uncertainty_at_te_m;
  };
}

StopRule loopDriven(double laps) {
  return [=](const ClosingCourse& c) {
    return c.loop_length_m > 0 && c.driven_m() >= laps * c.loop_length_m;
  };
}

StopRule armedAfter(double distance_m, StopRule rule) {
  return [=](const ClosingCourse& c) { return c.driven_m() >= distance_m && rule(c); };
}

StopRule never() {
  return [](const ClosingCourse&) { return false; };
}

StopRule stopRule(const ClosingParams& p) {
  switch (p.stop) {
    case Stop::neff:
      return neffConstantFor(p.neff_window_m, p.neff_change);
    case Stop::neff_slope:
      return neffFallsLessThan(p.neff_slope_per_m, p.neff_window_m);
    case Stop::uncertainty:
      return armedAfter(p.arm_distance_m, uncertaintyBackToEntry());
    case Stop::path_end:
      return loopDriven(1);
    case Stop::laps:
      return loopDriven(p.laps);
    case Stop::leaving:
    case Stop::never:
      break;
  }
  return never();
}

}  // namespace ariadne::loops
