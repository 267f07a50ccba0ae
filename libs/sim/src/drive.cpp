#include "ariadne/sim/drive.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/sim/robot.h"
#include "follower.h"

namespace ariadne::sim {
namespace {

using mrpt::math::TPose2D;

constexpr double kControlPeriod_s = 0.05;  // at most; a whole number of them is a scan's period

class Driver {
 public:
  Driver(const World& world, const TPose2D& start, const DrivePath& path, const DriveParams& params)
      : world_(world),
        path_(path),
        params_(params),
        follower_(path.waypoints, start, params),
        robot_(world, start, params) {}

  TruthDrive run(const DriveProgress& progress) {
    const double scan_period_s = 1 / params_.scan_rate_hz;
    const auto controls = static_cast<int>(std::ceil(scan_period_s / kControlPeriod_s - 1e-9));
    deadline_s_ = follower_.patience(pose());
    arrive();
    scan();
    for (std::size_t k = 0; !follower_.done(); ++k) {
      for (int c = 1; c <= controls; ++c)
        moveUntil((static_cast<double>(k) + static_cast<double>(c) / controls) * scan_period_s);
      time_s_ = static_cast<double>(k + 1) * scan_period_s;
      scan();
      if (progress)
        progress(static_cast<double>(follower_.reached()) /
                 static_cast<double>(path_.waypoints.size()));
    }
    return std::move(truth_);
  }

 private:
  const TPose2D& pose() const { return robot_.pose(); }

  void moveUntil(double time_s) {
    const bool moved = robot_.moveUntil(time_s, follower_.command(pose()));
    time_s_ = time_s;
    if (!moved) fail(fmt::format("touches rock with its radius of {} m", params_.robot_radius_m));
    arrive();
    if (!follower_.done() && time_s_ > deadline_s_)
      fail(fmt::format("is not at the next one, {}, in good time",
                       nameOf(path_.waypoints[follower_.reached()])));
  }

  void arrive() {
    const std::size_t before = follower_.reached();
    follower_.see(pose());
    if (follower_.reached() != before) deadline_s_ = time_s_ + follower_.patience(pose());
    for (; next_mark_ < path_.marks.size() && path_.marks[next_mark_].after <= follower_.reached();
         ++next_mark_)
      truth_.marks.push_back({path_.marks[next_mark_].name, time_s_});
  }

  void scan() {
    truth_.scans.push_back(robot_.scan());
    truth_.poses.push_back({time_s_, pose()});
  }

  std::string nameOf(const Waypoint& waypoint) const {
    return fmt::format("({}, {}) of {}:{}", waypoint.at.x, waypoint.at.y, path_.name,
                       waypoint.line);
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::size_t n = follower_.reached();
    throw core::Error(fmt::format(
        "{}: after {:.1f} s, at ({:.2f}, {:.2f}, {:.0f} deg) and behind {}, the robot {}",
        world_.name, time_s_, pose().x, pose().y, pose().phi * 180 / M_PI,
        n == 0 ? "the start" : "waypoint " + nameOf(path_.waypoints[n - 1]), what));
  }

  const World& world_;
  const DrivePath& path_;
  DriveParams params_;
  Follower follower_;
  Robot robot_;
  TruthDrive truth_;
  double time_s_ = 0;
  double deadline_s_ = 0;
  std::size_t next_mark_ = 0;
};

}  // namespace

TruthDrive driveThrough(const World& world, const DrivePath& path, const DriveParams& params,
                        const DriveProgress& progress) {
  core::validateFields(params, "drive");
  if (!world.start)
    throw core::Error(world.name + ": it names no start, so no drive can be scripted in it");
  return Driver(world, *world.start, path, params).run(progress);
}

}  // namespace ariadne::sim
