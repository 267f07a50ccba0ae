#include "ariadne/sim/robot.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/sim/collision.h"

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
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->sensorLabel = "laser";
  scan->timestamp = mrpt::Clock::fromDouble(time_s_ + 2e-8);  // it cuts off after 1e-7
  scan->aperture = static_cast<float>(params_.field_of_view_deg * M_PI / 180);
  scan->rightToLeft = true;
  scan->maxRange = static_cast<float>(params_.max_range_m);
  world_.map.laserScanSimulator(*scan, mrpt::poses::CPose2D(pose()), 0.5F,
                                static_cast<std::size_t>(params_.beams));
  // MRPT 2.5.8 gives a beam without return 0.8 of the maximum range.
  for (std::size_t i = 0; i < scan->getScanSize(); ++i)
    if (!scan->getScanRangeValidity(i)) scan->setScanRange(i, scan->maxRange);
  return scan;
}

}  // namespace ariadne::sim
