// The scans of the last metres, and the map that they alone make along a hypothesis: the second
// opinion on a match that the odometry disputes. A robot that comes back into a map that does not
// fit yet is pulled into it by metres or turned by 10 to 30 degrees; the last metres do not agree
// with that. Where its wheels slipped they do.
#pragma once
#include <deque>

#include "ariadne/filter/ancestry.h"
#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/models/proposal.h"
#include "ariadne/models/scan_matcher.h"

namespace ariadne::filter {

/// Mahalanobis distance of a pose from the prior's mean: how far off the odometry it is.
double sigmasOff(const mrpt::math::TPose2D& pose, const models::PosePrior& prior);

/// The scans of the last metres of a path, as a map of their own.
class RecentScans {
 public:
  /// @param sigmas a match that is further off the odometry is disputed; 0: none is
  RecentScans(const grid::GridParams& grid, double sigmas) : grid_(grid), sigmas_(sigmas) {}

  /// The scan of an update.
  /// @param travelled_m since the update before
  void add(std::size_t step, const grid::ScanShape& shape, double travelled_m);

  /// Whether a match is too far off the odometry to be believed unasked.
  bool dispute(const models::Match& match, const models::PosePrior& prior) const;

  /// The match with these scans alone, from where a hypothesis has them.
  /// @param prior of the robot's pose, map frame of `leaf`
  /// @param points ends of beams, m, robot's frame
  /// @param leaf the hypothesis at the update before
  models::Match matched(const models::PosePrior& prior, const models::ScanMatcher& matcher,
                        const std::vector<mrpt::math::TPoint2D>& points,
                        const AncestorPtr& leaf) const;

  /// Of a disputed match and that of the last metres, both in the map frame of one hypothesis: the
  /// latter where it places the robot under half as far off the odometry and fits better.
  static models::Match settled(const models::Match& match, const models::Match& recent,
                               const models::PosePrior& prior);

  /// Map of these scans alone, from where the hypothesis has them.
  grid::OccupancyGrid mapAlong(const AncestorPtr& leaf) const;

 private:
  struct Seen {
    std::size_t step;
    grid::ScanShape shape;
    double travelled_m;
  };
  grid::GridParams grid_;
  double sigmas_;
  double length_m_ = 0;
  std::deque<Seen> scans_;
};

}  // namespace ariadne::filter
