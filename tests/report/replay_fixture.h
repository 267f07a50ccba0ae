// A made-up filter to record: particles on a circle through a map that is painted as they go.
#pragma once
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/report/replay_recorder.h"
#include "ariadne/report/report_page.h"

namespace ariadne::test {

class MadeUpRun {
 public:
  MadeUpRun(std::size_t particles, double radius_m) : particles_(particles), radius_m_(radius_m) {}

  /// Moves on by 0.3 m, paints `cells` of the map about the robot at random, and records it.
  void update(report::ReplayRecorder& recorder, int cells) {
    const double angle = 0.3 / radius_m_ * static_cast<double>(step_);
    const mrpt::math::TPose2D pose(radius_m_ * std::cos(angle), radius_m_ * std::sin(angle),
                                   std::remainder(angle + M_PI / 2, 2 * M_PI));
    core::RandomStream rng(7, static_cast<std::uint32_t>(step_), 0, core::Purpose::motion);
    for (filter::Particle& p : particles_) {
      p.map_from_robot = {pose.x + 0.1 * rng.uniform(), pose.y + 0.1 * rng.uniform(), pose.phi};
      p.ancestor = std::make_shared<filter::Ancestor>(p.ancestor, step_, p.map_from_robot, 0);
    }
    grid::OccupancyGrid& map = particles_.front().map;
    for (int i = 0; i < cells; ++i)
      map.set(map.cellOf({pose.x + 20 * rng.uniform() - 10, pose.y + 20 * rng.uniform() - 10}),
              static_cast<std::int8_t>(i % 4 == 0 ? -60 : 40));
    slam::StepReport report;
    report.step = step_;
    report.time_s = 1e9 + 0.6 * static_cast<double>(step_++);
    report.neff = static_cast<double>(particles_.size());
    report.map_from_robot = pose;
    report.loops.state = state;
    recorder.step(report, view(), "at update " + std::to_string(report.step));
  }

  report::FilterView view() const {
    report::FilterView v;
    for (const filter::Particle& p : particles_) v.particles.push_back(&p);
    v.weights.assign(particles_.size(), 1.0 / static_cast<double>(particles_.size()));
    return v;
  }
  filter::Particle& best() { return particles_.front(); }

  loops::LoopState state = loops::LoopState::exploring;

 private:
  std::vector<filter::Particle> particles_;
  double radius_m_;
  std::size_t step_ = 0;
};

/// The data within a page. Throws when it is no JSON.
inline nlohmann::json dataOf(const std::string& page) {
  const std::string opening = "id=\"replay-data\">";
  const std::size_t from = page.find(opening) + opening.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

}  // namespace ariadne::test
