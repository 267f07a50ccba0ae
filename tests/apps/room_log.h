// A CARMEN log of a robot that circles in a room with a pillar, made up.
#pragma once
#include <fmt/format.h>

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

/// What else than a plain drive a log is.
struct Options {
  std::function<bool(int)> blind = [](int) { return false; };  ///< all ranges are "no return"
  std::function<double(int)> stamp = [](int i) { return 1000 + 0.2 * i; };
};

/// @param scans a tenth of a circle's metre each
inline std::string text(int scans, const Options& options = {}) {
  std::string out = "# made up\n";
  for (int i = 0; i < scans; ++i) {
    const double a = 0.04 * i;  // about 0.1 m of a circle of 2.5 m
    const double x = 2.5 * std::cos(a);
    const double y = 2.5 * std::sin(a);
    const double heading = a + M_PI / 2;
    out += "FLASER 181";
    for (int b = 0; b <= 180; ++b)
      out += options.blind(i)
                 ? " 81.91"
                 : fmt::format(" {:.3f}", range(x, y, heading + (b - 90) * M_PI / 180));
    const std::string pose = fmt::format("{:.4f} {:.4f} {:.5f}", x, y, heading);
    out += fmt::format(" {0} {0} {1:.2f} host {1:.2f}\n", pose, options.stamp(i));
  }
  return out;
}

}  // namespace room_log
