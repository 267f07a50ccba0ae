// topology.png and coalescence.png: what the loops did, to look at.
#pragma once
#include <filesystem>

#include "ariadne/slam/mapper.h"

namespace ariadne::slam_app {

/// G of s* over its map, with the entries of the closings, as the paper's Fig. 2.
void writeTopologyPicture(const std::filesystem::path& file, const slam::Mapper& mapper,
                          const mrpt::maps::COccupancyGridMap2D& map);

/// Unique ancestors of the final set at every past update, and of the last recovery the sets before
/// it (which no recovery would have left) and after it.
void writeCoalescencePicture(const std::filesystem::path& file, const slam::Mapper& mapper);

}  // namespace ariadne::slam_app
