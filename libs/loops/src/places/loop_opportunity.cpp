#include "ariadne/loops/places/loop_opportunity.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/grid/queries/free_distance.h"

namespace ariadne::loops {

void validate(const OpportunityParams& params, const std::string& section) {
  core::validateFields(params, section);
  if (params.c1_m >= params.c2_m)
    throw core::UsageError(
        fmt::format("[{}] c1_m = {} is not less than c2_m = {}: a loop is near by the map and far "
                    "by the graph (Eq. (7))",
                    section, params.c1_m, params.c2_m));
}

std::vector<PlaceOfInterest> placesOfInterest(const PlaceGraph& graph,
                                              const grid::OccupancyGrid& map,
                                              const mrpt::math::TPoint2D& position,
                                              const OpportunityParams& params,
                                              const std::function<bool(const Place&)>& counts) {
  const std::vector<double> dist_g = graph.distances();
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t i = 0; i < graph.places().size(); ++i) {
    const Place& place = graph.places()[i];
    // The straight line is a lower bound of dist_m.
    const double line = geometry::distance(place.position, position);
    // Eq. (7), but for dist_m, which is dear.
    if (dist_g[i] > params.c2_m && line < params.c1_m && counts(place)) candidates.push_back(i);
  }
  if (candidates.empty()) return {};

  std::vector<mrpt::math::TPoint2D> positions;
  for (const std::uint32_t i : candidates) positions.push_back(graph.places()[i].position);
  const grid::FreeDistance dist_m(map, position, params.c1_m, params.robot_radius_m, positions);
  std::vector<PlaceOfInterest> found;
  for (const std::uint32_t i : candidates) {
    const auto length = dist_m.toPlace(graph.places()[i].position);
    if (length && *length < params.c1_m) found.push_back({i, *length, dist_g[i]});
  }
  return found;
}

std::optional<LoopOpportunity> findOpportunity(const PlaceGraph& graph,
                                               const grid::OccupancyGrid& map,
                                               const mrpt::math::TPoint2D& position,
                                               const OpportunityParams& params,
                                               const std::function<bool(const Place&)>& counts) {
  LoopOpportunity found;
  found.places = placesOfInterest(graph, map, position, params, counts);
  if (found.places.empty()) return std::nullopt;
  // Eq. (9)
  const auto entry = std::min_element(
      found.places.begin(), found.places.end(),
      [](const PlaceOfInterest& a, const PlaceOfInterest& b) { return a.dist_m < b.dist_m; });
  found.entry = entry->place;
  found.te = graph.lastVisit(found.entry);
  found.dist_m_m = entry->dist_m;
  found.dist_g_m = entry->dist_g;
  return found;
}

}  // namespace ariadne::loops
