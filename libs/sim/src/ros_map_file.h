// Maps of ROS map_server and nav2 as worlds.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::sim {

/// The map where its origin lays it, turned by its yaw (placedGrid() says how). Floor is what the
/// servers call free; what they call occupied or unknown is rock. So is what nav2's saver wrote for
/// unknown, gray 205 in mode trinary, with a free_thresh that would take it for free: its default
/// of 0.25 was such a one until 2025. `notes` gets a sentence then. Throws core::Error naming file,
/// line and key, and what would be right.
mrpt::maps::COccupancyGridMap2D readRosMap(const std::filesystem::path& yaml,
                                           std::vector<std::string>& notes);

}  // namespace ariadne::sim
