// G of one particle over its map, as the paper's Fig. 2.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPoint2D.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace ariadne::report {

/// Where a closing entered, with the number it goes by.
struct DrawnEntry {
  mrpt::math::TPoint2D position;  ///< m, map frame
  std::size_t number = 0;
};

/// A graph of places as topology.png draws it.
struct DrawnGraph {
  std::vector<mrpt::math::TPoint2D> places;                    ///< m, map frame
  std::vector<std::pair<std::size_t, std::size_t>> edges;      ///< in the order they were driven
  std::vector<std::pair<std::size_t, std::size_t>> shortcuts;  ///< those that closed a cycle
  std::vector<DrawnEntry> entries;
};

/// PNG. Entries at one spot are drawn side by side. Throws core::Error naming the file.
void writeTopology(const std::filesystem::path& file, const mrpt::maps::COccupancyGridMap2D& map,
                   const DrawnGraph& graph);

}  // namespace ariadne::report
