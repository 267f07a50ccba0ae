// The picture to look at first: the path on the map.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

#include "ariadne/geometry/trajectory.h"

namespace ariadne::report {

/// PNG of the known part of the map, 600 to 1200 pixels on its longer side (less for under 15
/// cells; cells are shown by whole numbers of pixels, or the other way round), with the path
/// coloured in the order of time (blue to red, pose by pose), start and end, a scale bar in metres
/// and the path's length.
/// @param path map_from_robot, m; may be empty
/// Throws core::Error naming the file when it cannot be written or the map has no cells.
void writeOverview(const std::filesystem::path& file, const mrpt::maps::COccupancyGridMap2D& map,
                   const geometry::Trajectory& path);

}  // namespace ariadne::report
