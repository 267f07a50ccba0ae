// G of one particle over its map, as the paper's Fig. 2.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPoint2D.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace ariadne::report {

struct DrawnGraph {
  std::vector<mrpt::math::TPoint2D> places;                    ///< m, map frame
  std::vector<std::pair<std::size_t, std::size_t>> ways;       ///< in the order they were driven
  std::vector<std::pair<std::size_t, std::size_t>> shortcuts;  ///< those that closed a cycle
  std::vector<mrpt::math::TPoint2D> entries;  ///< entry points of the closings, in their order
};

/// PNG. Throws core::Error naming the file.
void writeTopology(const std::filesystem::path& file, const mrpt::maps::COccupancyGridMap2D& map,
                   const DrawnGraph& graph);

}  // namespace ariadne::report
