#include "steps_csv.h"

#include <fmt/format.h>

namespace ariadne::slam_app {

std::string stepsCsv(const std::vector<slam::StepReport>& reports) {
  std::string out =
      "step,time_s,neff,resampled,particles,matches_accepted,log_likelihood,best,x_m,y_m,phi_rad\n";
  for (const slam::StepReport& r : reports)
    out += fmt::format("{},{},{},{:d},{},{},{},{},{},{},{}\n", r.step, r.time_s, r.neff,
                       r.resampled, r.particles, r.matches_accepted, r.log_likelihood, r.best,
                       r.map_from_robot.x, r.map_from_robot.y, r.map_from_robot.phi);
  return out;
}

}  // namespace ariadne::slam_app
