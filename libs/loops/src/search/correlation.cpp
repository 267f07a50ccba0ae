#include "ariadne/loops/search/correlation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ariadne::loops {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Best heading and its score per offset of the window.
struct Scores {
  int side;
  std::vector<std::uint8_t> best;
  std::vector<int> turn;
};

/// Adds, for every offset of the window, whether a point ends on a wall there. Plain loops over
/// bytes: the compiler uses lanes.
void addPoint(const HitRaster& map, int column, int row, int side, std::uint8_t* sums) {
  for (int j = 0; j < side; ++j) {
    const std::uint8_t* from = map.line(row + j) + column;
    std::uint8_t* to = sums + static_cast<std::ptrdiff_t>(j) * side;
    for (int i = 0; i < side; ++i) to[i] = static_cast<std::uint8_t>(to[i] + from[i]);
  }
}

}  // namespace

std::vector<Mode> correlate(const HitRaster& map, const std::vector<TPoint2D>& points,
                            const TPose2D& predicted, const SearchWindow& window,
                            double turn_step_rad, double apart_m, std::size_t count) {
  if (points.empty() || points.size() > 255)
    throw std::invalid_argument("loops::correlate: 1 to 255 points");
  const int half = std::max(1, static_cast<int>(std::ceil(window.half_m / map.cell())));
  const int turns = static_cast<int>(std::ceil(window.half_turn_rad / turn_step_rad));
  Scores scores{2 * half + 1, {}, {}};
  const auto cells = static_cast<std::size_t>(scores.side) * static_cast<std::size_t>(scores.side);
  scores.best.assign(cells, 0);
  scores.turn.assign(cells, 0);
  std::vector<std::uint8_t> sums(cells);
  for (int t = -turns; t <= turns; ++t) {
    std::fill(sums.begin(), sums.end(), 0);
    const TPose2D pose(predicted.x, predicted.y, predicted.phi + t * turn_step_rad);
    const double c = std::cos(pose.phi), s = std::sin(pose.phi);
    for (const TPoint2D& p : points) {
      const int column = map.column(pose.x + c * p.x - s * p.y) - half;
      const int row = map.row(pose.y + s * p.x + c * p.y) - half;
      if (column < 0 || row < 0 || column + scores.side > map.size() ||
          row + scores.side > map.size())
        continue;
      addPoint(map, column, row, scores.side, sums.data());
    }
    for (std::size_t i = 0; i < cells; ++i)
      if (sums[i] > scores.best[i] ||
          (sums[i] == scores.best[i] && std::abs(t) < std::abs(scores.turn[i]))) {
        scores.best[i] = sums[i];
        scores.turn[i] = t;
      }
  }
  std::vector<Mode> modes;
  const int apart = static_cast<int>(std::ceil(apart_m / map.cell()));
  while (modes.size() < count) {
    const auto top = std::max_element(scores.best.begin(), scores.best.end());
    if (*top == 0) break;
    const auto at = static_cast<int>(top - scores.best.begin());
    const int i = at % scores.side, j = at / scores.side;
    const int turn = scores.turn[static_cast<std::size_t>(at)];
    Mode mode;
    mode.map_from_piece = {predicted.x + (i - half) * map.cell(),
                           predicted.y + (j - half) * map.cell(),
                           predicted.phi + turn * turn_step_rad};
    mode.hit_share = static_cast<double>(*top) / static_cast<double>(points.size());
    mode.at_edge =
        i == 0 || j == 0 || i == scores.side - 1 || j == scores.side - 1 || std::abs(turn) == turns;
    modes.push_back(mode);
    for (int y = std::max(0, j - apart); y <= std::min(scores.side - 1, j + apart); ++y)
      for (int x = std::max(0, i - apart); x <= std::min(scores.side - 1, i + apart); ++x)
        scores.best[static_cast<std::size_t>(y) * static_cast<std::size_t>(scores.side) +
                    static_cast<std::size_t>(x)] = 0;
  }
  return modes;
}

}  // namespace ariadne::loops
