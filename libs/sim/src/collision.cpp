#include "ariadne/sim/collision.h"

#include <algorithm>

namespace ariadne::sim {

bool touchesRock(const mrpt::maps::COccupancyGridMap2D& map, double x, double y, double radius) {
  const double cell = map.getResolution();
  const int width = static_cast<int>(map.getSizeX());
  const int height = static_cast<int>(map.getSizeY());
  for (int iy = map.y2idx(y - radius); iy <= map.y2idx(y + radius); ++iy) {
    for (int ix = map.x2idx(x - radius); ix <= map.x2idx(x + radius); ++ix) {
      const bool outside = ix < 0 || iy < 0 || ix >= width || iy >= height;
      if (!outside && map.getCell(ix, iy) > 0.5F) continue;
      const double left = map.getXMin() + ix * cell;
      const double bottom = map.getYMin() + iy * cell;
      const double dx = x - std::clamp(x, left, left + cell);
      const double dy = y - std::clamp(y, bottom, bottom + cell);
      if (dx * dx + dy * dy < radius * radius) return true;
    }
  }
  return false;
}

}  // namespace ariadne::sim
