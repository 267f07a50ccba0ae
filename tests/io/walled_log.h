// Rawlogs of a robot among straight walls, without noise unless asked for: what a laser of a given
// reach, rounding and code for "nothing" sees.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ariadne/core/random.h"
#include "sample_logs.h"

namespace sample {

struct Wall {
  double x0, y0, x1, y1;
};
using Walls = std::vector<Wall>;

/// Four walls about the origin.
inline Walls room(double width, double height) {
  const double x = width / 2, y = height / 2;
  return {{-x, -y, x, -y}, {x, -y, x, y}, {x, y, -x, y}, {-x, y, -x, -y}};
}

/// Distance along a beam to the first wall; 1000 where there is none.
inline double distance(const Walls& walls, const TPose2D& pose, double angle) {
  const double dx = std::cos(pose.phi + angle), dy = std::sin(pose.phi + angle);
  double nearest = 1000;
  for (const Wall& w : walls) {
    const double ex = w.x1 - w.x0, ey = w.y1 - w.y0;
    const double cross = dx * ey - dy * ex;
    if (std::abs(cross) < 1e-12) continue;
    const double ox = w.x0 - pose.x, oy = w.y0 - pose.y;
    const double along = (ox * ey - oy * ex) / cross, at = (ox * dy - oy * dx) / cross;
    if (along > 1e-9 && at >= 0 && at <= 1) nearest = std::min(nearest, along);
  }
  return nearest;
}

struct Laser {
  double reach_m = 70;
  double rounding_m = 0.001;
  double noise_m = 0;
  std::vector<float> nothing = {81.91F};  ///< beyond the reach: one of these by turns
  float max_range_m = 80;                 ///< in the header
  double begin_s = kBegin_s;
  bool odometry = true;  ///< false: it stays at 0
};

/// 181 beams over 180 degrees a pose, 0.2 s apart.
inline std::string walledLog(const Walls& walls, const std::vector<TPose2D>& poses,
                             const Laser& laser) {
  Rawlog log;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    ariadne::core::RandomStream random(1, static_cast<std::uint32_t>(k), 0,
                                       ariadne::core::Purpose::test);
    auto s = scan(laser.begin_s + 0.2 * static_cast<double>(k), "", 181);
    s->maxRange = laser.max_range_m;
    s->sensorPose = {};
    for (std::size_t i = 0; i < 181; ++i) {
      const double angle = (static_cast<double>(i) - 90) * M_PI / 180;
      double range = distance(walls, poses[k], angle);
      if (laser.noise_m > 0) range += laser.noise_m * random.gaussian();
      range = range < laser.reach_m ? std::round(range / laser.rounding_m) * laser.rounding_m
                                    : laser.nothing[(i / 3 + k) % laser.nothing.size()];
      s->setScanRange(i, static_cast<float>(range));
      s->setScanRangeValidity(i, range < laser.max_range_m);
    }
    const bool moves = laser.odometry && k > 0;
    log.add(action(moves ? poses[k] - poses[k - 1] : TPose2D())).frame({s});
  }
  return log.bytes();
}

struct Corner {
  double x, y;
};
/// Along straight lines from corner to corner, turning on the spot.
inline std::vector<TPose2D> driveAlong(const std::vector<Corner>& corners, double step_m = 0.15,
                                       double turn_rad = 0.3) {
  std::vector<TPose2D> poses;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const double dx = corners[k + 1].x - corners[k].x, dy = corners[k + 1].y - corners[k].y;
    const double heading = std::atan2(dy, dx), length = std::hypot(dx, dy);
    if (!poses.empty()) {
      const double turn = std::remainder(heading - poses.back().phi, 2 * M_PI);
      const int turns = static_cast<int>(std::abs(turn) / turn_rad);
      for (int i = 1; i <= turns; ++i)
        poses.emplace_back(corners[k].x, corners[k].y, heading - turn + turn * i / (turns + 1));
    }
    for (double at = 0; at < length; at += step_m)
      poses.emplace_back(corners[k].x + at * dx / length, corners[k].y + at * dy / length, heading);
  }
  return poses;
}

}  // namespace sample
