// The topological map G of one particle (section IV): places it visited, joined by the edges it
// took. Copying a graph shares its history.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"
#include "ariadne/loops/places/params.h"
#include "ariadne/loops/places/shared_list.h"

namespace ariadne::loops {

/// A node of the graph: where the robot was.
struct Place {
  mrpt::math::TPoint2D position;  ///< m, map frame of the particle
  std::uint32_t step = 0;         ///< filter update at which it was made
};

/// The robot drove from one place to the other.
struct Edge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  float length_m = 0;
  std::uint32_t step = 0;  ///< when it was taken first
};

/// Where the robot was in the graph at one filter update.
struct Visit {
  std::uint32_t place = 0;        ///< last place visited
  bool inside = false;            ///< within its visit radius and in sight of it
  float stub_m = 0;               ///< driven since that place
  mrpt::math::TPoint2D position;  ///< of the robot, m, map frame of the particle
};

/// The graph G of a particle: places that the robot was at, joined where it drove. Copies share
/// what they have in common.
class PlaceGraph {
 public:
  /// In the order in which they were made.
  const SharedList<Place>& places() const { return places_; }
  /// In the order in which they were driven.
  const SharedList<Edge>& edges() const { return edges_; }
  /// One a filter update, in order.
  const SharedList<Visit>& visits() const { return visits_; }

  /// Takes the next filter update: the pose and map (with this update's scan) of the particle.
  /// A visit to a known place joins it with the last one; where none is near, a place is made.
  void extend(const mrpt::math::TPoint2D& position, const grid::OccupancyGrid& map,
              const PlaceParams& params);
  /// Joins the present place with `place`, as closing a loop does in every particle's G.
  void close(std::uint32_t place);

  /// The graph as of update `step`, which it must have taken.
  PlaceGraph asOf(std::size_t step) const;

  /// Goes on as `other` did after the last update of this graph: its later places, at the positions
  /// that this particle was at in the same updates, and its later edges.
  /// @param positions one an update that `other` has more, m
  void attach(const PlaceGraph& other, const std::vector<mrpt::math::TPoint2D>& positions);

  /// dist_G: shortest path in G from the robot to every place, m; infinity where there is none.
  std::vector<double> distances() const;
  /// Last update at which the robot was at the place: te of an entry point.
  std::size_t lastVisit(std::uint32_t place) const;

 private:
  void arriveAt(std::uint32_t place, double length_m);
  void make(const mrpt::math::TPoint2D& position);
  bool observesAny(const mrpt::math::TPoint2D& position, const grid::OccupancyGrid& map,
                   double range_m) const;
  bool joined(std::uint32_t a, std::uint32_t b) const;

  SharedList<Place> places_;
  SharedList<Edge> edges_;
  SharedList<Visit> visits_;
};

}  // namespace ariadne::loops
