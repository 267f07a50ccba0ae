// Logs that do not make sense through ariadne-slam, and what a run said of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ariadne/geometry/pose.h"
#include "ariadne/geometry/trajectory.h"
#include "ariadne/io/tum.h"
#include "slam_app_fixture.h"

class SlamSense : public SlamApp {
 protected:
  nlohmann::json summary(const char* run) const {
    return nlohmann::json::parse(ariadne::io::readWhole(folder / run / "summary.json"));
  }
  ariadne::geometry::Trajectory path(const char* run, const char* file = "trajectory.tum") const {
    return ariadne::io::readTum(folder / run / file);
  }
  static std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
    return n;
  }
  /// Largest distance between poses of the two paths, both seen from their first.
  static double farthest(const ariadne::geometry::Trajectory& a,
                         const ariadne::geometry::Trajectory& b) {
    EXPECT_EQ(a.size(), b.size());
    double worst = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      const auto p = ariadne::geometry::relativePose(a[0].pose, a[i].pose);
      const auto q = ariadne::geometry::relativePose(b[0].pose, b[i].pose);
      worst = std::max(worst, std::hypot(p.x - q.x, p.y - q.y));
    }
    return worst;
  }
};
