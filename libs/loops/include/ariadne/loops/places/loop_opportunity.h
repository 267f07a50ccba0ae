// The set of places of interest I(s), Eq. (7), and the entry point x_te, Eq. (9).
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <functional>
#include <optional>
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/loops/places/place_graph.h"

namespace ariadne::loops {

/// An element of I(s): a place near by the map and far by the graph.
struct PlaceOfInterest {
  std::uint32_t place = 0;  ///< index in the graph
  double dist_m = 0;        ///< m
  double dist_g = 0;        ///< m
};

/// A loop that can be closed.
struct LoopOpportunity {
  std::vector<PlaceOfInterest> places;  ///< I(s), in the order of the graph; never empty
  std::uint32_t entry = 0;              ///< x_te: the place of I(s) nearest by the map
  std::size_t te = 0;                   ///< last filter update at which the robot was there
  double dist_m_m = 0;                  ///< dist_m to the entry, m
  double dist_g_m = 0;                  ///< dist_G to the entry, m
};

/// I(s), Eq. (7). Searches the map only when a place is near as the crow flies and far by the
/// graph.
/// @param position of the robot, m, map frame
/// @param counts whether a place may be in I(s); the caller's hysteresis
std::vector<PlaceOfInterest> placesOfInterest(const PlaceGraph& graph,
                                              const grid::OccupancyGrid& map,
                                              const mrpt::math::TPoint2D& position,
                                              const OpportunityParams& params,
                                              const std::function<bool(const Place&)>& counts);

/// I(s) with its entry point, Eq. (9); nothing when I(s) is empty.
std::optional<LoopOpportunity> findOpportunity(const PlaceGraph& graph,
                                               const grid::OccupancyGrid& map,
                                               const mrpt::math::TPoint2D& position,
                                               const OpportunityParams& params,
                                               const std::function<bool(const Place&)>& counts);

}  // namespace ariadne::loops
