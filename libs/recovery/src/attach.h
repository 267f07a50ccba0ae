// Attaching a way through the loop to a hypothesis of its entry, Eq. (13).
#pragma once
#include <vector>

#include "ariadne/filter/particle.h"
#include "ariadne/grid/scan_shape.h"
#include "ariadne/recovery/saved_set.h"

namespace ariadne::recovery {

/// The way x_te+1:t of one particle, as motion seen from its pose at te.
struct Segment {
  std::vector<mrpt::math::TPose2D> te_from_robot;  ///< one an update from te + 1 on
  std::vector<double> log_weight;                  ///< increments of the same updates
};
Segment segmentOf(const filter::AncestorPtr& leaf, std::size_t te);

/// The entry's map as of te: its checkpoint and the scans since.
grid::OccupancyGrid mapAtTe(const SavedEntry& entry, const std::vector<grid::ScanShape>& shapes);

/// The entry's trajectory and map with the segment after it, x~_k = x~_te (+) (x_te^-1 (+) x_k):
/// absolute coordinates would erase the differences that were saved.
/// @param shapes scans of all updates, by number
filter::Particle attach(const SavedEntry& entry, const grid::OccupancyGrid& map_at_te,
                        const Segment& segment, const std::vector<grid::ScanShape>& shapes,
                        std::size_t checkpoint_updates);

/// Share of the segment's beams that end where the entry's own map at te is surely free: 0 when the
/// way agrees with what the hypothesis knew before. A sample of every fourth scan and beam.
double contradiction(const grid::OccupancyGrid& map_at_te, const filter::AncestorPtr& leaf,
                     std::size_t te, const std::vector<grid::ScanShape>& shapes);

}  // namespace ariadne::recovery
