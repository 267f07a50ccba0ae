// topology.png and coalescence.png: what the loops did, to look at.
#pragma once
#include <filesystem>

#include "ariadne/slam/mapper.h"

namespace ariadne::slam_app {

/// G of s* over its map, as the paper's Fig. 2, with the entries of the closings by their numbers
/// in loops.json.
void writeTopologyPicture(const std::filesystem::path& file, const slam::Mapper& mapper,
                          const mrpt::maps::COccupancyGridMap2D& map);

/// Unique ancestors of the final set at every past update, and for each recovery those of the sets
/// before it (which no recovery would have left) and after it. Numbers are those of loops.json.
void writeCoalescencePicture(const std::filesystem::path& file, const slam::Mapper& mapper);

}  // namespace ariadne::slam_app
