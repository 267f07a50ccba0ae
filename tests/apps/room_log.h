// A CARMEN log of a robot that circles in a room with a pillar, made up.
#pragma once
#include <fmt/format.h>
#include <mrpt/math/TPose2D.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace room_log {

/// Range from (x, y) along `angle` to the walls of a 10 x 8 m room or its 1 x 1 m pillar.
inline double range(double x, double y, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  double best = 1e9;
  const auto wall = [&](double at, double from, double direction, double other,
                        double other_direction, double low, double high) {
    if (std::abs(direction) < 1e-9) return;
    const double r = (at - from) / direction;
    const double hit = other + r * other_direction;
    if (r > 1e-6 && hit >= low && hit <= high) best = std::min(best, r);
  };
  for (double at : {-5.0, 5.0}) wall(at, x, c, y, s, -4, 4);
  for (double at : {-4.0, 4.0}) wall(at, y, s, x, c, -5, 5);
  for (double at : {-0.5, 0.5}) {
    wall(at, x, c, y, s, -0.5, 0.5);
    wall(at, y, s, x, c, -0.5, 0.5);
  }
  return best;
}

/// Where scan `i` is taken: 0.1 m apart on a circle of 2.5 m.
inline mrpt::math::TPose2D pose(int i) {
  const double a = 0.04 * i;
  return {2.5 * std::cos(a), 2.5 * std::sin(a), a + M_PI / 2};
}

/// What else than a plain drive a log is.
struct Options {
  std::function<bool(int)> blind = [](int) { return false; };  ///< all ranges are "no return"
  std::function<double(int)> stamp = [](int i) { return 1000 + 0.2 * i; };
  /// What the odometry says at scan i, from where the robot is.
  std::function<mrpt::math::TPose2D(int, const mrpt::math::TPose2D&)> odometry =
      [](int, const mrpt::math::TPose2D& p) { return p; };
  std::function<double(double)> reading = [](double r) { return r; };  ///< of a range, m
  bool clockwise = false;  ///< the laser turns to the right, and its lines say so
};

inline std::string text(int scans, const Options& options = {}) {
  std::string out = "# made up\n";
  for (int i = 0; i < scans; ++i) {
    const auto at = pose(i), told = options.odometry(i, at);
    out += options.clockwise ? "ROBOTLASER1 0 1.570796 -3.141593 -0.01745329 80 0.01 0 181"
                             : "FLASER 181";
    for (int b = 0; b <= 180; ++b) {
      const double angle = (options.clockwise ? 90 - b : b - 90) * M_PI / 180;
      const double r = range(at.x, at.y, at.phi + angle);
      out += options.blind(i) ? " 81.91" : fmt::format(" {:.3f}", options.reading(r));
    }
    const std::string place = fmt::format("{:.4f} {:.4f} {:.5f}", told.x, told.y, told.phi);
    out += fmt::format("{2} {0} {0}{3} {1:.2f} host {1:.2f}\n", place, options.stamp(i),
                       options.clockwise ? " 0" : "", options.clockwise ? " 0 0 0 0 0" : "");
  }
  return out;
}

}  // namespace room_log
