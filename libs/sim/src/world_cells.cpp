#include "world_cells.h"

#include <algorithm>
#include <cmath>

namespace ariadne::sim {

double Block::reachX() const { return std::abs(cos) * half_length + std::abs(sin) * half_width; }
double Block::reachY() const { return std::abs(sin) * half_length + std::abs(cos) * half_width; }

Block rectangle(double x0, double y0, double x1, double y1, bool rock) {
  return {(x0 + x1) / 2, (y0 + y1) / 2, 1, 0, std::abs(x1 - x0) / 2, std::abs(y1 - y0) / 2, rock};
}

std::vector<Block> corridorBlocks(double width_m, const std::vector<mrpt::math::TPoint2D>& line) {
  std::vector<Block> blocks;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step_x = line[i].x - line[i - 1].x;
    const double step_y = line[i].y - line[i - 1].y;
    const double length = std::hypot(step_x, step_y);
    Block block;
    block.x = (line[i].x + line[i - 1].x) / 2;
    block.y = (line[i].y + line[i - 1].y) / 2;
    if (length > 0) {
      block.cos = step_x / length;
      block.sin = step_y / length;
    }
    block.half_length = (length + width_m) / 2;
    block.half_width = width_m / 2;
    blocks.push_back(block);
  }
  return blocks;
}

void paint(mrpt::maps::COccupancyGridMap2D& map, const Block& block) {
  const int last_x = static_cast<int>(map.getSizeX()) - 1;
  const int last_y = static_cast<int>(map.getSizeY()) - 1;
  const int x0 = std::clamp(map.x2idx(block.x - block.reachX()) - 1, 0, last_x);
  const int x1 = std::clamp(map.x2idx(block.x + block.reachX()) + 1, 0, last_x);
  const int y0 = std::clamp(map.y2idx(block.y - block.reachY()) - 1, 0, last_y);
  const int y1 = std::clamp(map.y2idx(block.y + block.reachY()) + 1, 0, last_y);
  const double resolution = map.getResolution();
  for (int iy = y0; iy <= y1; ++iy) {
    const double dy = map.getYMin() + (iy + 0.5) * resolution - block.y;
    for (int ix = x0; ix <= x1; ++ix) {
      const double dx = map.getXMin() + (ix + 0.5) * resolution - block.x;
      const double along = dx * block.cos + dy * block.sin;
      const double across = dy * block.cos - dx * block.sin;
      if (std::abs(along) < block.half_length && std::abs(across) < block.half_width)
        map.setCell(ix, iy, block.rock ? kRock : kFree);
    }
  }
}

}  // namespace ariadne::sim
