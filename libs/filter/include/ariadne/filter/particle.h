// What one hypothesis is: a trajectory (its line of ancestors), its own map, its accumulated
// weight.
#pragma once
#include <memory>

#include "ariadne/core/release_chain.h"
#include "ariadne/filter/ancestry.h"
#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::filter {

/// A particle's map as of a past update, and the ones before it. Copy-on-write: it costs the tiles
/// that changed since.
struct Checkpoint {
  std::size_t step = 0;
  grid::OccupancyGrid map;
  mutable std::shared_ptr<const Checkpoint> earlier;  ///< let go one by one by the destructor

  /// @param at filter update
  Checkpoint(std::size_t at, const grid::OccupancyGrid& as_of,
             std::shared_ptr<const Checkpoint> before)
      : step(at), map(as_of), earlier(std::move(before)) {}
  ~Checkpoint() {
    core::releaseChain(
        std::move(earlier), [](const Checkpoint& c) -> auto& { return c.earlier; });
  }
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;
};

/// Copying one shares everything.
struct Particle {
  mrpt::math::TPose2D map_from_robot;
  grid::OccupancyGrid map = grid::OccupancyGrid();  // explicit: clang takes no {} for it
  AncestorPtr ancestor;
  std::shared_ptr<const Checkpoint> checkpoints;  ///< latest first

  /// a of Eq. (8): sum of log weight increments along the line.
  double accumulated() const { return ancestor ? ancestor->accumulated() : 0; }
};

}  // namespace ariadne::filter
