#include "ariadne/sim/robot.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/sim/collision.h"
#include "laser.h"

namespace ariadne::sim {
namespace {

constexpr double kMotorLag_s = 0.1;

}  // namespace

Robot::Robot(const World& world, const mrpt::math::TPose2D& start, const DriveParams& params)
    : world_(world), params_(params) {
  core::validateFields(params, "drive");
  vehicle_.setDelayModelParams(kMotorLag_s);
  vehicle_.resetTime();
  vehicle_.setCurrentGTPose(start);
  if (touches())
    throw core::Error(
        fmt::format("{}: at its start ({:.2f}, {:.2f}) the robot, with its radius of "
                    "{} m, touches something",
                    world.name, start.x, start.y, params.robot_radius_m));
}

bool Robot::touches() const {
  return touchesRock(world_.bodies, pose().x, pose().y, params_.robot_radius_m);
}

// The vehicle moves by whole periods of its firmware (0.5 ms) and may end one late; asking for a
// time instead of an interval keeps that from adding up.
bool Robot::moveUntil(double time_s, const models::VelocityCommand& command) {
  const mrpt::math::TPose2D before = pose();
  vehicle_.movementCommand(command.forward_m_s, command.turn_rad_s);
  vehicle_.simulateOneTimeStep(time_s - vehicle_.getTime());
  time_s_ = time_s;
  if (!touches()) return true;
  vehicle_.setCurrentGTPose(before);
  return false;
}

mrpt::obs::CObservation2DRangeScan::Ptr Robot::scan() const {
  auto scan = scanFrom(world_, pose(), params_);
  scan->timestamp = mrpt::Clock::fromDouble(time_s_ + 2e-8);  // it cuts off after 1e-7
  return scan;
}

}  // namespace ariadne::sim
