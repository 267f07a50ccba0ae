// A map of s* drawn with letters: '#' wall, '.' free, ' ' unknown; the last row is y = 0.
#pragma once
#include <string>
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::test {

/// Every letter is `scale` x `scale` cells of 0.05 m; the lower left corner is the origin.
inline grid::OccupancyGrid drawnMap(const std::vector<std::string>& rows, int scale) {
  grid::GridParams params;
  params.resolution_m = 0.05;
  grid::OccupancyGrid map(params);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      if (rows[r][c] == ' ') continue;
      for (int y = 0; y < scale; ++y)
        for (int x = 0; x < scale; ++x)
          map.set(
              {static_cast<int>(c) * scale + x, static_cast<int>(rows.size() - 1 - r) * scale + y},
              rows[r][c] == '#' ? -50 : 50);
    }
  return map;
}

}  // namespace ariadne::test
