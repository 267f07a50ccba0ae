// dist_m: lengths of shortest paths for a round robot through cells known to be free.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::grid {

/// One search from a point, on the eight neighbours of a cell (a path's length is at most 8 % over
/// the straight line's). Unknown cells block as walls do.
class FreeDistance {
 public:
  /// @param from m, map frame
  /// @param limit_m paths longer than this are not followed
  /// @param robot_radius_m cells whose centre is this near to the centre of one that is not free
  /// are not entered; but the robot may leave the disc of that radius in which it stands already
  /// @param targets when there are any, only paths to them need be right: the search keeps to the
  /// box of the ellipses in which paths no longer than the limit lie
  FreeDistance(const OccupancyGrid& map, const mrpt::math::TPoint2D& from, double limit_m,
               double robot_radius_m, const std::vector<mrpt::math::TPoint2D>& targets = {});

  /// Length of the shortest path to the centre of the cell of `to`, m; nothing when there is none
  /// within the limit.
  std::optional<double> to(const mrpt::math::TPoint2D& to) const;
  /// As to(), for a place where a robot has been: in its own map it may stand a little too near to
  /// a wall, so that the path to the best cell within the robot's radius and on to it counts.
  std::optional<double> toPlace(const mrpt::math::TPoint2D& to) const;

 private:
  int index(Cell c) const;
  /// Whether there is a path to the cell with this index, which may be -1.
  bool isReached(int i) const;
  void openCells(Cell start);
  void search(int start);

  OccupancyGrid map_;
  double resolution_;
  double robot_radius_m_;
  Cell corner_;
  int width_;
  int height_;
  std::vector<std::int32_t> units_;  // path lengths, 1/70 of a cell, or why there is none
  std::int32_t limit_units_;
};

}  // namespace ariadne::grid
