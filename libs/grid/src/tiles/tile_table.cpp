#include "ariadne/grid/tiles/tile_table.h"

#include <algorithm>

#include "ariadne/core/error.h"

namespace ariadne::grid {

CellBox widened(const CellBox& box, int bx, int by, std::int64_t most) {
  const CellBox wide = box.empty() ? CellBox{bx, by, bx + 1, by + 1}
                                   : CellBox{std::min(box.x0, bx), std::min(box.y0, by),
                                             std::max(box.x1, bx + 1), std::max(box.y1, by + 1)};
  const std::int64_t width = std::int64_t{wide.x1} - wide.x0;
  const std::int64_t height = std::int64_t{wide.y1} - wide.y0;
  if (width * height > most)
    throw core::Error(
        "the map would span more than 68 billion cells: a pose ran away "
        "(check the odometry, or take a coarser resolution)");
  return wide;
}

}  // namespace ariadne::grid
