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

/// The scans of the last metres of a path, as a map of their own.
class RecentScans {
 public:
  /// @param sigmas a match that is further off the odometry is disputed; 0: none is
  RecentScans(const grid::GridParams& grid, double sigmas) : grid_(grid), sigmas_(sigmas) {}

  /// The scan of an update.
  /// @param travelled_m since the update before
  void add(std::size_t step, const grid::ScanShape& shape, double travelled_m);

  /// The match; where it is disputed, and these scans alone place the robot under half as far off
  /// the odometry and fit better, the match with them.
  /// @param match of `points` (m, robot's frame) with the whole map of the hypothesis
  /// @param leaf the hypothesis at the update before
  models::Match settled(const models::Match& match, const models::PosePrior& prior,
                        const models::ScanMatcher& matcher,
                        const std::vector<mrpt::math::TPoint2D>& points,
                        const AncestorPtr& leaf) const;

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
