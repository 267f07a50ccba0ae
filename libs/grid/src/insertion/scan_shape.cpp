#include "ariadne/grid/insertion/scan_shape.h"

#include <algorithm>
#include <cmath>

#include "insertion/scan_returns.h"

namespace ariadne::grid {
namespace {

using mrpt::math::TPoint2D;
using mrpt::obs::CObservation2DRangeScan;

// Of scanFeatures(); see there.
constexpr double kNearReach = 0.8;
constexpr double kWallEnd_m = 0.5;

/// Maps (range, angle) in the laser's plane to the robot's frame, seen from above.
class LaserFrame {
 public:
  explicit LaserFrame(const mrpt::poses::CPose3D& robot_from_laser)
      : rotation_(robot_from_laser.getRotationMatrix()),
        origin_(robot_from_laser.x(), robot_from_laser.y()) {}
  TPoint2D origin() const { return origin_; }
  TPoint2D point(double range, double angle) const {
    const double x = range * std::cos(angle);
    const double y = range * std::sin(angle);
    return {origin_.x + rotation_(0, 0) * x + rotation_(0, 1) * y,
            origin_.y + rotation_(1, 0) * x + rotation_(1, 1) * y};
  }

 private:
  mrpt::math::CMatrixDouble33 rotation_;
  TPoint2D origin_;
};

struct BeamAngles {
  double first;
  double step;
  double at(std::size_t i) const { return first + step * static_cast<double>(i); }
};

BeamAngles beamAngles(const CObservation2DRangeScan& scan) {
  const std::size_t n = scan.getScanSize();
  // More than a full turn would fold the outline over itself.
  const double aperture = std::min<double>(scan.aperture, 2 * M_PI);
  const double side = scan.rightToLeft ? 1 : -1;
  return {-side * aperture / 2, n > 1 ? side * aperture / static_cast<double>(n - 1) : 0};
}

bool returned(const CObservation2DRangeScan& scan, std::size_t i) {
  const float range = scan.getScanRange(i);
  return scan.getScanRangeValidity(i) && std::isfinite(range) && range > 0 && range < scan.maxRange;
}

double freeRange(const CObservation2DRangeScan& scan, std::size_t i, const GridParams& params) {
  const double range = scan.getScanRange(i);
  if (!returned(scan, i))
    return range >= scan.maxRange ? std::min(params.no_return_free_m, params.insert_range_m) : 0;
  return range < params.insert_range_m ? std::max(0.0, range - params.resolution_m)
                                       : params.insert_range_m;
}

/// Neighbouring readings on one surface, seen no flatter than about 6 degrees.
bool sameSurface(double a, double b, double step) {
  return std::abs(a - b) < 10 * std::abs(step) * std::min(a, b);
}

}  // namespace

std::vector<TPoint2D> outlineOf(const CObservation2DRangeScan& scan, const GridParams& params) {
  std::vector<TPoint2D> outline;
  const std::size_t n = scan.getScanSize();
  if (n < 2) return outline;
  const LaserFrame laser(scan.sensorPose);
  const BeamAngles angles = beamAngles(scan);
  std::vector<double> ranges(n);
  for (std::size_t i = 0; i < n; ++i) ranges[i] = freeRange(scan, i, params);

  outline.reserve(3 * n + 3);
  outline.push_back(laser.origin());
  for (std::size_t i = 0; i < n; ++i) {
    outline.push_back(laser.point(ranges[i], angles.at(i)));
    // At an edge each beam keeps its own half of the gap.
    if (i + 1 < n && !sameSurface(ranges[i], ranges[i + 1], angles.step)) {
      const double middle = angles.at(i) + angles.step / 2;
      outline.push_back(laser.point(ranges[i], middle));
      outline.push_back(laser.point(ranges[i + 1], middle));
    }
  }
  return outline;
}

ScanReturns returnsOf(const CObservation2DRangeScan& scan, double max_range_m) {
  ScanReturns returns;
  const LaserFrame laser(scan.sensorPose);
  const BeamAngles angles = beamAngles(scan);
  returns.points.reserve(scan.getScanSize());
  returns.beams.reserve(scan.getScanSize());
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    if (!returned(scan, i) || scan.getScanRange(i) >= max_range_m) continue;
    returns.points.push_back(laser.point(scan.getScanRange(i), angles.at(i)));
    returns.beams.push_back(i);
  }
  return returns;
}

ScanShape makeScanShape(const CObservation2DRangeScan& scan, const GridParams& params) {
  if (scan.getScanSize() < 2) return {};
  return {outlineOf(scan, params), scanPoints(scan, params.insert_range_m)};
}

std::vector<TPoint2D> scanPoints(const CObservation2DRangeScan& scan, double max_range_m) {
  return returnsOf(scan, max_range_m).points;
}

bool isBlind(const CObservation2DRangeScan& scan, const GridParams& params, double least_returns) {
  if (params.no_return_free_m > 0) return false;
  const std::size_t n = scan.getScanSize();
  const double enough = least_returns * static_cast<double>(n);
  double returns = 0;
  for (std::size_t i = 0; i < n && returns < enough; ++i)
    returns += returned(scan, i) && scan.getScanRange(i) < params.insert_range_m;
  return returns < enough;
}

std::vector<TPoint2D> scanFeatures(const CObservation2DRangeScan& scan, double max_range_m,
                                   double few) {
  return featuresOf(scan, returnsOf(scan, max_range_m), few);
}

std::vector<TPoint2D> featuresOf(const CObservation2DRangeScan& scan, const ScanReturns& returns,
                                 double few) {
  const std::vector<TPoint2D>& points = returns.points;
  const std::size_t n = scan.getScanSize();
  if (static_cast<double>(points.size()) >= few * static_cast<double>(n)) return points;
  std::vector<bool> cut_off(points.size(), false);
  for (std::size_t end = 0; end < points.size(); ++end)
    for (const int inward : {1, -1}) {
      // Counting down from 0 leaves the range of both, as counting up past the end does.
      const std::size_t beyond = returns.beams[end] - static_cast<std::size_t>(inward);
      if (beyond >= n || scan.getScanRange(beyond) < scan.maxRange) continue;
      if (scan.getScanRange(returns.beams[end]) < kNearReach * scan.maxRange) continue;
      for (std::size_t i = end; i < points.size() && (points[i] - points[end]).norm() < kWallEnd_m;
           i += static_cast<std::size_t>(inward))
        cut_off[i] = true;
    }
  std::vector<TPoint2D> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!cut_off[i]) kept.push_back(points[i]);
  return kept;
}

}  // namespace ariadne::grid
