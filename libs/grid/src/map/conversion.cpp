#include "ariadne/grid/map/conversion.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "ariadne/core/error.h"

namespace ariadne::grid {
namespace {

using mrpt::maps::COccupancyGridMap2D;

static_assert(std::is_same_v<COccupancyGridMap2D::cellType, std::int8_t>,
              "Ariadne's cells are MRPT's 8-bit cells");

/// setSize() rounds borders to multiples of the resolution; an imported map may lie elsewhere.
class PlacedGrid : public COccupancyGridMap2D {
 public:
  PlacedGrid(const mrpt::math::TPoint2D& corner, std::uint32_t width, std::uint32_t height,
             double resolution) {
    m_resolution = static_cast<float>(resolution);
    m_size_x = width;
    m_size_y = height;
    m_xMin = static_cast<float>(corner.x);
    m_yMin = static_cast<float>(corner.y);
    m_xMax = static_cast<float>(corner.x + width * resolution);
    m_yMax = static_cast<float>(corner.y + height * resolution);
    m_map.assign(std::size_t{width} * height, 0);
    m_is_empty = false;
  }
};

/// The decimal number that a float was made from: 0.05, not 0.0500000007.
double decimal(float value) { return std::round(static_cast<double>(value) * 1e7) / 1e7; }

}  // namespace

COccupancyGridMap2D toMrpt(const OccupancyGrid& grid) {
  CellBox box = grid.knownBox();
  if (box.empty()) box = {0, 0, 1, 1};
  const std::int64_t width = std::int64_t{box.x1} - box.x0;
  const std::int64_t height = std::int64_t{box.y1} - box.y0;
  if (width * height > (std::int64_t{1} << 32))
    throw core::Error(fmt::format(
        "the map spans {} x {} cells, too many for MRPT's dense grid (did a pose run away?)", width,
        height));
  const double r = grid.resolution();
  PlacedGrid out({grid.origin().x + box.x0 * r, grid.origin().y + box.y0 * r},
                 static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), r);
  grid.cells().forEachTile([&](int tx, int ty, const EvidencePlane::Cells& cells) {
    const int x0 = std::max(tx * kTileCells, box.x0);
    const int x1 = std::min((tx + 1) * kTileCells, box.x1);
    const int y1 = std::min((ty + 1) * kTileCells, box.y1);
    for (int y = std::max(ty * kTileCells, box.y0); y < y1 && x0 < x1; ++y)
      std::copy_n(&cells[tileOffset(x0, y)], x1 - x0, out.getRow(y - box.y0) + (x0 - box.x0));
  });
  return COccupancyGridMap2D(out);
}

OccupancyGrid fromMrpt(const COccupancyGridMap2D& grid, GridParams params) {
  params.resolution_m = decimal(grid.getResolution());
  OccupancyGrid out(params);
  const double r = params.resolution_m;
  const Cell corner{static_cast<int>(std::lround(grid.getXMin() / r)),
                    static_cast<int>(std::lround(grid.getYMin() / r))};
  // Floats are exact to a hundredth of a cell only; less than that is no offset.
  const auto offset = [&](double place, int cell) {
    const double d = place - cell * r;
    return std::abs(d) < 0.01 * r ? 0.0 : d;
  };
  out.clear({offset(grid.getXMin(), corner.x), offset(grid.getYMin(), corner.y)});
  for (unsigned y = 0; y < grid.getSizeY(); ++y) {
    const auto* row = grid.getRow(static_cast<int>(y));
    for (unsigned x = 0; x < grid.getSizeX(); ++x)
      if (row[x] != 0)
        out.set({corner.x + static_cast<int>(x), corner.y + static_cast<int>(y)}, row[x]);
  }
  return out;
}

}  // namespace ariadne::grid
