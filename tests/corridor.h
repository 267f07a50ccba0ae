// A corridor 2 m wide round a block, 100 m along its middle, with doors every 5 m; what a laser
// sees of it, and a drive once around. Neighbouring scans overlap nearly everywhere.
#pragma once
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::test {

class CorridorWorld {
 public:
  /// @param irregular m by which the doors stand off their even places: evenly spaced ones look
  /// alike
  explicit CorridorWorld(double irregular = 0) : irregular_(irregular) {
    addWalls({-1, -1}, {31, 21}, -0.3);
    addWalls({1, 1}, {29, 19}, 0.3);
  }

  /// Range (m) of a beam, at most 80.
  double range(const mrpt::math::TPoint2D& from, double angle) const {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    double nearest = 80;
    for (const Wall& w : walls_) {
      const double det = c * w.along.y - s * w.along.x;
      if (std::abs(det) < 1e-12) continue;
      const double dx = w.from.x - from.x;
      const double dy = w.from.y - from.y;
      const double distance = (dx * w.along.y - dy * w.along.x) / det;
      const double at = (dx * s - dy * c) / det;
      if (distance > 0 && at >= 0 && at <= 1) nearest = std::min(nearest, distance);
    }
    return nearest;
  }

  /// 181 beams over 180 degrees with 1 cm of noise; 20 m is the longest reading.
  mrpt::obs::CObservation2DRangeScan scan(const mrpt::math::TPose2D& map_from_robot,
                                          core::RandomStream& rng) const {
    mrpt::obs::CObservation2DRangeScan scan;
    scan.aperture = static_cast<float>(M_PI);
    scan.rightToLeft = true;
    scan.maxRange = 20;
    scan.resizeScan(181);
    for (std::size_t i = 0; i < 181; ++i) {
      const double angle = map_from_robot.phi + M_PI * (static_cast<double>(i) / 180 - 0.5);
      const double r = range({map_from_robot.x, map_from_robot.y}, angle) + 0.01 * rng.gaussian();
      scan.setScanRange(i, static_cast<float>(std::clamp(r, 0.02, 20.0)));
      scan.setScanRangeValidity(i, r < 20);
    }
    return scan;
  }

 private:
  struct Wall {
    mrpt::math::TPoint2D from;
    mrpt::math::TPoint2D along;
  };
  void addWall(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) {
    walls_.push_back({a, b - a});
  }
  /// The four walls of a box; a door is a niche `depth` m into the box (out of it when negative).
  void addWalls(const mrpt::math::TPoint2D& low, const mrpt::math::TPoint2D& high, double depth) {
    const mrpt::math::TPoint2D corner[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (int i = 0; i < 4; ++i) {
      const auto along = corner[(i + 1) % 4] - corner[i];
      const double length = std::hypot(along.x, along.y);
      const auto unit = along * (1 / length);
      const mrpt::math::TPoint2D inwards(-unit.y * depth, unit.x * depth);
      auto last = corner[i];
      for (double at = 2; at + 1 < length;
           at += 5 + irregular_ * std::sin(37 * at + 11 * i + depth)) {
        const auto begin = corner[i] + unit * at;
        const auto end = begin + unit;
        addWall(last, begin);
        addWall(begin, begin + inwards);
        addWall(begin + inwards, end + inwards);
        addWall(end + inwards, end);
        last = end;
      }
      addWall(last, corner[(i + 1) % 4]);
    }
  }
  double irregular_;
  std::vector<Wall> walls_;
};

/// Poses every `step_m` along the middle of the corridor, counterclockwise, from (0, 0).
inline std::vector<mrpt::math::TPose2D> corridorDrive(double step_m = 0.3) {
  std::vector<mrpt::math::TPose2D> poses;
  for (double s = 0; s < 100; s += step_m) {
    const double wander = 0.1 * std::sin(0.7 * s);
    const double turn = 0.15 * std::cos(0.4 * s);
    if (s < 30)
      poses.push_back({s, wander, turn});
    else if (s < 50)
      poses.push_back({30 + wander, s - 30, M_PI / 2 + turn});
    else if (s < 80)
      poses.push_back({80 - s, 20 + wander, M_PI + turn});
    else
      poses.push_back({wander, 100 - s, -M_PI / 2 + turn});
  }
  return poses;
}

struct Drive {
  std::vector<grid::ScanShape> shapes;
  std::vector<mrpt::math::TPose2D> poses;
  std::vector<grid::PlacedScan> placed() const {
    std::vector<grid::PlacedScan> scans;
    for (std::size_t i = 0; i < poses.size(); ++i) scans.push_back({&shapes[i], poses[i]});
    return scans;
  }
};

/// Once round the corridor, turned by `heading` rad about its start: nothing lies along the grid.
inline Drive corridorLoop(const grid::GridParams& params = {}, double heading = 0) {
  const CorridorWorld world;
  core::RandomStream rng(100, 0, 0, core::Purpose::test);
  const mrpt::math::TPose2D turned(0, 0, heading);
  Drive drive;
  for (const auto& pose : corridorDrive()) {
    drive.shapes.push_back(grid::makeScanShape(world.scan(pose, rng), params));
    drive.poses.push_back(turned + pose);
  }
  return drive;
}

}  // namespace ariadne::test
