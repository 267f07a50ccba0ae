#include "ariadne/mission/reachable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "ariadne/core/error.h"
#include "ariadne/sim/collision.h"

namespace ariadne::mission {

using mrpt::math::TPoint2D;

std::vector<TPoint2D> reachablePlaces(const sim::World& world, const mrpt::math::TPose2D& start,
                                      double robot_radius_m, double apart_m) {
  const auto& map = world.bodies;
  const double cell_m = map.getResolution();
  const auto place = [&](int dx, int dy) {
    return TPoint2D{start.x + dx * cell_m, start.y + dy * cell_m};
  };
  const auto stands = [&](const TPoint2D& p) {
    return !sim::touchesRock(map, p.x, p.y, robot_radius_m);
  };
  if (!stands({start.x, start.y}))
    throw core::Error(fmt::format("{}: the robot cannot stand at ({:.2f}, {:.2f})", world.name,
                                  start.x, start.y));
  // It never leaves the map, since beyond all is rock.
  const int side = static_cast<int>(std::max(map.getSizeX(), map.getSizeY())) + 1;
  const auto index = [&](int dx, int dy) {
    return static_cast<std::size_t>(dy + side) * (2 * side + 1) + dx + side;
  };
  std::vector<std::uint8_t> seen(index(side, side) + 1, 0);
  std::vector<std::pair<int, int>> open{{0, 0}};
  seen[index(0, 0)] = 1;
  // The first place that the search comes to in each square of that side: none is left out.
  const int every = std::max(1, static_cast<int>(std::lround(apart_m / cell_m)));
  std::set<std::pair<int, int>> squares;
  std::vector<TPoint2D> places;
  for (std::size_t k = 0; k < open.size(); ++k) {
    const auto [x, y] = open[k];
    const auto below = [&](int v) { return (v + side * every) / every; };
    if (squares.emplace(below(x), below(y)).second) places.push_back(place(x, y));
    for (const auto& [nx, ny] : {std::pair{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
      if (seen[index(nx, ny)]) continue;
      seen[index(nx, ny)] = 1;
      if (stands(place(nx, ny))) open.emplace_back(nx, ny);
    }
  }
  return places;
}

}  // namespace ariadne::mission
