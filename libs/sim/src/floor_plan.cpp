#include "floor_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/core/error.h"
#include "world_cells.h"

namespace ariadne::sim {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPose2D;

constexpr double kFinest_m = 0.005;
constexpr double kQuarter = M_PI / 2;

/// Left, right, bottom, top of the plan in the world, in m.
struct Box {
  double left, right, bottom, top;
};

Box boxOf(double width_m, double height_m, const TPose2D& pose) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  const auto x = std::minmax({0.0, c * width_m, -s * height_m, c * width_m - s * height_m});
  const auto y = std::minmax({0.0, s * width_m, c * height_m, s * width_m + c * height_m});
  return {pose.x + x.first, pose.x + x.second, pose.y + y.first, pose.y + y.second};
}

Grid rockIn(const Box& box, double resolution_m) {
  const auto f = [](double value) { return static_cast<float>(value); };
  Grid grid(f(box.left), f(box.right), f(box.bottom), f(box.top), f(resolution_m));
  grid.fill(kRock);
  return grid;
}

/// Whether the cell (x, y) of the plan turned to the left `quarters` times is floor.
bool isFloorTurned(const FloorPlan& plan, int quarters, int x, int y) {
  const int right = plan.columns - 1, top = plan.rows - 1;
  if (quarters == 1) return plan.isFloor(y, top - x);
  if (quarters == 2) return plan.isFloor(right - x, top - y);
  if (quarters == 3) return plan.isFloor(right - y, x);
  return plan.isFloor(x, y);
}

Grid gridOfQuarters(const FloorPlan& plan, double resolution_m, const TPose2D& pose, int quarters) {
  const bool upright = quarters % 2 == 0;
  const int columns = upright ? plan.columns : plan.rows;
  const int rows = upright ? plan.rows : plan.columns;
  const Box box = boxOf(plan.columns * resolution_m, plan.rows * resolution_m,
                        {pose.x, pose.y, quarters * kQuarter});
  // MRPT's grids begin at whole cells. Rounded one by one the two sides could differ by a cell.
  const double left = resolution_m * std::round(box.left / resolution_m);
  const double bottom = resolution_m * std::round(box.bottom / resolution_m);
  Grid grid = rockIn({left, left + columns * resolution_m, bottom, bottom + rows * resolution_m},
                     resolution_m);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      if (isFloorTurned(plan, quarters, x, y)) grid.setCell(x, y, kFree);
  return grid;
}

/// Which of a plan's cells a square of the turned grid covers; lengths are cells of the plan.
class Cover {
 public:
  Cover(const FloorPlan& plan, double yaw, double side)
      : plan_(plan),
        cos_(std::cos(yaw)),
        sin_(std::sin(yaw)),
        turn_(std::abs(cos_) + std::abs(sin_)),
        reach_along_plan_(0.5 + side / 2 * turn_),
        reach_along_square_(side / 2 + 0.5 * turn_) {}

  /// Whether all is floor under the square whose centre is (x, y) of the plan. Two squares overlap
  /// unless an axis of one of them parts them.
  bool allFloor(double x, double y) const {
    const auto cell = [](double value) { return static_cast<int>(std::floor(value)); };
    for (int iy = cell(y - reach_along_plan_); iy <= cell(y + reach_along_plan_); ++iy)
      for (int ix = cell(x - reach_along_plan_); ix <= cell(x + reach_along_plan_); ++ix) {
        if (plan_.isFloor(ix, iy)) continue;
        const double dx = ix + 0.5 - x, dy = iy + 0.5 - y;
        if (std::max(std::abs(dx), std::abs(dy)) < reach_along_plan_ &&
            std::abs(cos_ * dx - sin_ * dy) < reach_along_square_ &&
            std::abs(sin_ * dx + cos_ * dy) < reach_along_square_)
          return false;
      }
    return true;
  }

 private:
  const FloorPlan& plan_;
  double cos_, sin_, turn_;
  double reach_along_plan_, reach_along_square_;  // between the centres of two that touch
};

Grid gridOfAngle(const FloorPlan& plan, double resolution_m, const TPose2D& pose,
                 const std::string& name) {
  const Box box = boxOf(plan.columns * resolution_m, plan.rows * resolution_m, pose);
  const double cells =
      (box.right - box.left) * (box.top - box.bottom) / (resolution_m * resolution_m);
  if (cells > kMostCells)
    throw core::Error(
        fmt::format("{}: turned by {:.4g} rad it takes {:.3g} cells, over {:.0e}: a yaw of 0 in "
                    "origin would do",
                    name, pose.phi, cells, kMostCells));
  const double half = resolution_m / 2;
  Grid grid = rockIn(box, half >= kFinest_m && 4 * cells <= kMostCells ? half : resolution_m);
  const Cover cover(plan, pose.phi, grid.getResolution() / resolution_m);
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  for (int y = 0; y < static_cast<int>(grid.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x) {
      const double dx = (grid.idx2x(x) - pose.x) / resolution_m;
      const double dy = (grid.idx2y(y) - pose.y) / resolution_m;
      if (cover.allFloor(c * dx + s * dy, c * dy - s * dx)) grid.setCell(x, y, kFree);
    }
  return grid;
}

}  // namespace

FloorPlan::FloorPlan(int columns_, int rows_)
    : columns(columns_),
      rows(rows_),
      floor(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

FloorPlan::FloorPlan(const io::PicturePixels& picture, const std::array<bool, 256>& floor_shades)
    : FloorPlan(picture.width, picture.height) {
  std::size_t pixel = 0;
  for (int y = rows; y-- > 0;)
    for (int x = 0; x < columns; ++x, ++pixel)
      at(x, y) = floor_shades[picture.shade[pixel]] && picture.opaque(pixel) ? 1 : 0;
}

std::uint8_t& FloorPlan::at(int x, int y) {
  return floor[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(x)];
}

bool FloorPlan::isFloor(int x, int y) const {
  return x >= 0 && y >= 0 && x < columns && y < rows && const_cast<FloorPlan*>(this)->at(x, y) != 0;
}

Grid placedGrid(const FloorPlan& plan, double resolution_m, const TPose2D& world_from_plan,
                const std::string& name) {
  constexpr double kWithin = 0.25;  // of a cell
  const double quarters = std::round(world_from_plan.phi / kQuarter);
  const double off = std::abs(world_from_plan.phi - quarters * kQuarter);
  if (off * std::max(plan.columns, plan.rows) > kWithin)
    return gridOfAngle(plan, resolution_m, world_from_plan, name);
  return gridOfQuarters(plan, resolution_m, world_from_plan, (static_cast<int>(quarters) + 4) % 4);
}

}  // namespace ariadne::sim
