#include "ariadne/mission/mission.h"

#include <cmath>

#include "ariadne/explore/strategy.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/sim/robot.h"
#include "ariadne/sim/senses.h"

namespace ariadne::mission {
namespace {

MissionParams withStrategy(MissionParams params) {
  explore::applyStrategy(params.explore.strategy, params.slam);
  return params;
}

/// The robot's motion from scan to scan, in short periods so that a contact is found where it is.
class Drive {
 public:
  Drive(const sim::World& world, const mrpt::math::TPose2D& start, const sim::DriveParams& params)
      : robot_(world, start, params) {}

  const sim::Robot& robot() const { return robot_; }
  double travelled_m() const { return travelled_m_; }

  /// Returns whether the robot touched something.
  bool until(double time_s, const models::VelocityCommand& command) {
    constexpr double kPeriod_s = 0.05;
    const double from_s = robot_.time_s();
    const int periods = static_cast<int>(std::ceil((time_s - from_s) / kPeriod_s - 1e-9));
    bool touched = false;
    for (int i = 1; i <= periods; ++i) {
      const mrpt::math::TPose2D before = robot_.pose();
      // Held against a wall it may still turn or back off.
      touched |= !robot_.moveUntil(from_s + (time_s - from_s) * i / periods, command);
      travelled_m_ += geometry::distance(robot_.pose(), before);
    }
    return touched;
  }

 private:
  sim::Robot robot_;
  double travelled_m_ = 0;
};

}  // namespace

Mission::Mission(const sim::World& world, const mrpt::math::TPose2D& start,
                 const MissionParams& params, int threads)
    : params_(withStrategy(params)),
      world_(world),
      start_(start),
      mapper_(params_.slam, threads),
      explorer_(params_.explore) {
  sim::Robot(world_, start_, params_.sim.drive);  // throws where it cannot stand
}

MissionRecord Mission::run(const MissionListener& listener) {
  MissionRecord record;
  Drive drive(world_, start_, params_.sim.drive);
  sim::Senses senses(params_.sim.noise, params_.slam.filter.seed);
  const auto timeOf = [&](std::size_t k) {
    // To MRPT's 100 ns, as a rawlog keeps it.
    return std::round(static_cast<double>(k) / params_.sim.drive.scan_rate_hz * 1e7) / 1e7;
  };
  bool touched = false;
  bool touched_before = false;
  record.end_reason = "stopped";
  for (std::size_t k = 0; !explorer_.done(); ++k) {
    const geometry::StampedPose truth{timeOf(k), drive.robot().pose()};
    record.truth.push_back(truth);
    record.steps.push_back(senses.next(truth, *drive.robot().scan()));
    const models::SensorStep& step = record.steps.back();
    const auto report = mapper_.process(step);
    const auto command =
        explorer_.step(explore::beliefOf(mapper_, step.time_s, *step.scan, touched));
    if (report) {
      record.reports.push_back(*report);
      if (listener && !listener(*report, explorer_)) break;
    }
    touched_before = touched;
    touched = drive.until(timeOf(k + 1), command);
    if (touched && !touched_before)
      record.collisions.push_back({drive.robot().time_s(), drive.robot().pose()});
  }
  if (explorer_.done()) record.end_reason = explorer_.endReason();
  record.distance_m = drive.travelled_m();
  return record;
}

}  // namespace ariadne::mission
