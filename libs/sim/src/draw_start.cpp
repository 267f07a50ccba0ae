#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/sim/collision.h"
#include "ariadne/sim/world.h"

namespace ariadne::sim {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

/// Cells, row by row, on whose centres the disc stands: 1; all others: 0.
std::vector<std::uint8_t> standable(const Grid& map, double radius_m) {
  const int width = static_cast<int>(map.getSizeX());
  std::vector<std::uint8_t> cells(map.getSizeX() * map.getSizeY());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int x = static_cast<int>(i) % width;
    const int y = static_cast<int>(i) / width;
    cells[i] = map.getCell(x, y) > 0.5F && !touchesRock(map, map.idx2x(x), map.idx2y(y), radius_m);
  }
  return cells;
}

/// All cells that hang together with `first` over edges; sets them to `mark`.
std::size_t fill(std::vector<std::uint8_t>& cells, std::size_t first, std::size_t width,
                 std::uint8_t mark) {
  const std::uint8_t from = cells[first];
  std::vector<std::size_t> open{first};
  cells[first] = mark;
  std::size_t count = 0;
  const auto visit = [&](std::size_t i) {
    if (cells[i] != from) return;
    cells[i] = mark;
    open.push_back(i);
  };
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    ++count;
    if (i % width > 0) visit(i - 1);
    if (i % width + 1 < width) visit(i + 1);
    if (i >= width) visit(i - width);
    if (i + width < cells.size()) visit(i + width);
  }
  return count;
}

constexpr std::uint8_t kOther = 2;
constexpr std::uint8_t kLargest = 3;

/// Marks the largest region in which the disc can drive about; false when there is none.
bool markLargest(std::vector<std::uint8_t>& cells, std::size_t width) {
  std::size_t largest = 0;
  std::size_t within = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != 1) continue;
    const std::size_t size = fill(cells, i, width, kOther);
    if (size > largest) {
      largest = size;
      within = i;
    }
  }
  return largest > 0 && fill(cells, within, width, kLargest) > 0;
}

}  // namespace

mrpt::math::TPose2D drawStart(const World& world, double robot_radius_m, std::uint64_t seed) {
  constexpr double kHand_m = 0.1;
  const Grid& map = world.bodies;
  const std::size_t width = map.getSizeX();
  std::vector<std::uint8_t> cells = standable(map, robot_radius_m + kHand_m);
  if (!markLargest(cells, width))
    throw core::Error(fmt::format("{}: no place found where a robot of radius {} m could start",
                                  world.name, robot_radius_m));
  core::RandomStream random(seed, 0, 0, core::Purpose::start);
  std::size_t i = 0;
  do {
    i = static_cast<std::size_t>(random.uniform() * static_cast<double>(cells.size()));
  } while (i >= cells.size() || cells[i] != kLargest);
  return {map.idx2x(static_cast<int>(i % width)), map.idx2y(static_cast<int>(i / width)),
          (2 * random.uniform() - 1) * M_PI};
}

}  // namespace ariadne::sim
