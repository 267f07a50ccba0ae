#include "neff_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/charts/curves.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/slam/mapper.h"

namespace ariadne::eval_app {
namespace {

/// Way along the true path up to each of its poses, m.
std::vector<double> travelledAlong(const geometry::Trajectory& truth) {
  std::vector<double> travelled_m{0};
  for (std::size_t i = 1; i < truth.size(); ++i)
    travelled_m.push_back(travelled_m.back() +
                          geometry::distance(truth[i].pose, truth[i - 1].pose));
  return travelled_m;
}

charts::Curve neffOf(const std::string& name, const slam::SlamParams& params,
                     const sim::SimulatedDrive& drive, const std::vector<double>& travelled_m) {
  charts::Curve curve{name, {}, {}};
  slam::Mapper mapper(params, 1);
  for (std::size_t i = 0; i < drive.steps.size(); ++i)
    if (const auto report = mapper.process(drive.steps[i])) {
      curve.x.push_back(travelled_m[i]);
      curve.y.push_back(report->neff);
    }
  return curve;
}

}  // namespace

void writeNeffChart(const std::filesystem::path& file, const experiment::LoopConfig& config,
                    const sim::TruthDrive& truth, std::uint64_t seed) {
  const sim::SimulatedDrive drive = sim::observe(truth, config.sim.noise, seed);
  const std::vector<double> travelled_m = travelledAlong(drive.truth);
  charts::CurveChart chart{"Neff before resampling", "distance, m", "Neff", {}, {}};
  slam::SlamParams params = config.slam;
  params.filter.seed = seed;
  params.recovery.enabled = false;
  for (const double exponent : {0.0, 2.0}) {
    params.filter.revisit_exponent = exponent;
    chart.curves.push_back(neffOf(exponent == 0 ? "plain weights" : "1/r^2 at the r-th revisit",
                                  params, drive, travelled_m));
  }
  for (const sim::MarkTime& m : drive.marks) {
    const auto at = std::lower_bound(
        drive.truth.begin(), drive.truth.end(), m.time_s,
        [&](const auto& p, double t) { return p.time_s - drive.truth[0].time_s < t; });
    const auto i = std::min<std::size_t>(at - drive.truth.begin(), travelled_m.size() - 1);
    chart.moments.push_back({m.name, travelled_m[i]});
  }
  charts::writeCurves(file, chart);
}

}  // namespace ariadne::eval_app
