// Attaching a path through the loop to a hypothesis of its entry, Eq. (13).
#pragma once
#include <vector>

#include "ariadne/filter/particle.h"
#include "ariadne/grid/insertion/scan_shape.h"
#include "ariadne/loops/recovery/saved_set.h"

namespace ariadne::loops {

/// The entry's map as of te: its checkpoint and the scans since.
grid::OccupancyGrid mapAtTe(const SavedEntry& entry, const std::vector<grid::ScanShape>& shapes);

/// The entry's trajectory and map with the path `leaf` after it.
/// @param leaf descends from entry.at_te, see AttachedPaths
/// @param shapes scans of all updates, by number
filter::Particle attach(const SavedEntry& entry, const grid::OccupancyGrid& map_at_te,
                        const filter::AncestorPtr& leaf, const std::vector<grid::ScanShape>& shapes,
                        std::size_t checkpoint_updates);

/// Share of the segment's beams that end where the entry's own map at te is surely free: 0 when the
/// path agrees with what the hypothesis knew before. A sample of every fourth scan and beam.
double contradiction(const grid::OccupancyGrid& map_at_te, const filter::AncestorPtr& leaf,
                     std::size_t te, const std::vector<grid::ScanShape>& shapes);

}  // namespace ariadne::loops
