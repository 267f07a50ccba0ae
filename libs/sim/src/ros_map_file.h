// Maps of ROS map_server: a YAML and its picture. Read here and not by MRPT, whose YAML parser
// (libfyaml 0.7) did not come back from 17 bytes in a minute of a busy machine.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

namespace ariadne::sim {

/// Free cells are those that map_server calls free, by negate and free_thresh (0.196 where it is
/// missing); all others are rock. http://wiki.ros.org/map_server
/// Throws core::Error naming line and key, and what would be right.
mrpt::maps::COccupancyGridMap2D readRosMap(const std::filesystem::path& yaml);

}  // namespace ariadne::sim
