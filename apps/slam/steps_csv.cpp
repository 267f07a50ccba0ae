#include "steps_csv.h"

#include <fmt/format.h>

namespace ariadne::slam_app {

namespace {

const char* nameOf(loops::LoopState state) {
  switch (state) {
    case loops::LoopState::approaching:
      return "approaching";
    case loops::LoopState::closing:
      return "closing";
    case loops::LoopState::exploring:
      break;
  }
  return "exploring";
}

std::string numberOrNothing(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace

std::string stepsCsv(const std::vector<slam::StepReport>& reports) {
  std::string out =
      "step,time_s,neff,resampled,particles,matches_accepted,log_likelihood,best,x_m,y_m,phi_rad,"
      "loop_state,opportunities,dist_m_m,dist_g_m,unique_ancestors\n";
  for (const slam::StepReport& r : reports) {
    out += fmt::format("{},{},{},{:d},{},{},{},{},{},{},{},", r.step, r.time_s, r.neff, r.resampled,
                       r.particles, r.matches_accepted, r.log_likelihood, r.best,
                       r.map_from_robot.x, r.map_from_robot.y, r.map_from_robot.phi);
    out += fmt::format("{},{},{},{},{}\n", nameOf(r.loops.state), r.loops.opportunities,
                       numberOrNothing(r.loops.dist_m), numberOrNothing(r.loops.dist_g),
                       r.loops.unique_ancestors);
  }
  return out;
}

}  // namespace ariadne::slam_app
