// Where a rigid piece of scans fits a map best, over a window of poses: all of them are tried
// (correlative scan matching, E. Olson, "Real-time correlative scan matching", ICRA 2009). The
// whole volume is scored, so that it is known how good the second-best place is.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

#include "ariadne/loops/search/hit_raster.h"

namespace ariadne::loops {

/// Half widths about the predicted pose.
struct SearchWindow {
  double half_m = 5;
  double half_turn_rad = 0.25;
};

/// A place that the piece fits.
struct Mode {
  mrpt::math::TPose2D map_from_piece;
  double hit_share = 0;  ///< share of the piece's points that end on a mapped wall
  bool at_edge = false;  ///< of the window: the true peak may lie outside
};

/// The best places, `apart_m` from each other at the least, best first, at most `count`.
/// @param points of the piece, m, piece's frame; at most 255
/// @param predicted map_from_piece
std::vector<Mode> correlate(const HitRaster& map, const std::vector<mrpt::math::TPoint2D>& points,
                            const mrpt::math::TPose2D& predicted, const SearchWindow& window,
                            double turn_step_rad, double apart_m, std::size_t count);

}  // namespace ariadne::loops
