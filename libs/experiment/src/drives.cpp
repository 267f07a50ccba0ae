#include "ariadne/experiment/drives.h"

#include <fmt/format.h>

#include <filesystem>

#include "ariadne/core/error.h"
#include "ariadne/io/dataset.h"

namespace ariadne::experiment {
namespace {

std::string nameOf(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.', 1));
}

void checkFiles(const DriveFiles& files) {
  if (files.log.empty() && !files.world.empty() && !files.path.empty()) return;
  if (!files.log.empty() && files.world.empty() && files.path.empty()) return;
  throw core::UsageError("[experiment] takes either world and path, or log");
}

}  // namespace

Drives::Drives(const LoopConfig& config, std::optional<int> laps)
    : noise_(config.sim.noise), log_noise_(config.log_noise) {
  checkFiles(config.files);
  if (!config.files.log.empty()) {
    if (laps) throw core::UsageError("a log has no laps to choose: leave --laps out");
    readLog(config);
    return;
  }
  name_ = nameOf(config.files.path);
  const sim::World world = sim::readWorld(config.files.world);
  const sim::DrivePath path = sim::readPath(config.files.path, laps);
  laps_ = path.has_laps_block ? path.laps : 0;
  simulated_ = sim::driveThrough(world, path, config.sim.drive);
}

void Drives::readLog(const LoopConfig& config) {
  name_ = nameOf(config.files.log);
  const auto source = io::openDataset(config.files.log);
  while (auto step = source->next()) {
    if (log_noise_.restamp_s > 0)
      step->time_s = log_noise_.restamp_s * static_cast<double>(log_.steps.size());
    log_.truth.push_back({step->time_s, step->odom_from_robot});
    log_.steps.push_back(std::move(*step));
  }
  if (log_noise_.restamp_s == 0 && source->counts().scan_clock.count > 0)
    throw core::Error(fmt::format(
        "{}: its clock was set back, and the experiment finds truth by time: set [log_noise] restamp_s",
        config.files.log));
}

sim::SimulatedDrive Drives::observe(std::uint64_t seed) const {
  if (simulated_) return sim::observe(*simulated_, noise_, seed);
  sim::SimulatedDrive seen = log_;
  io::NoisyOdometry odometry(log_noise_.motion, seed);
  for (models::SensorStep& step : seen.steps)
    step.odom_from_robot = odometry.add(step.odom_from_robot);
  return seen;
}

}  // namespace ariadne::experiment
