#include "ariadne/grid/map/occupancy_grid.h"

#include <algorithm>
#include <limits>

#include "ariadne/grid/tiles/rounding.h"
#include "tiles/tile_mask.h"

namespace ariadne::grid {
namespace {

const GridParams& validated(const GridParams& params) {
  core::validateFields(params, "grid");
  return params;
}

}  // namespace

OccupancyGrid::OccupancyGrid(const GridParams& params)
    : resolution_(validated(params).resolution_m),
      evidence_(beamEvidence(params)),
      cells_(evidence_.free),
      field_(params.field_sigma_m / params.resolution_m) {}

Cell OccupancyGrid::cellOf(const mrpt::math::TPoint2D& p) const {
  return {floorToInt((p.x - origin_.x) / resolution_), floorToInt((p.y - origin_.y) / resolution_)};
}

mrpt::math::TPoint2D OccupancyGrid::centreOf(Cell c) const {
  return {origin_.x + (c.x + 0.5) * resolution_, origin_.y + (c.y + 0.5) * resolution_};
}

void OccupancyGrid::set(Cell c, std::int8_t log_odds) {
  const std::int8_t before = at(c);
  if (before == log_odds) return;
  cells_.set(c.x, c.y, log_odds);
  if (before >= 0 && log_odds < 0) field_.occupy(c);
  if (before < 0 && log_odds >= 0) field_.update({{c.x, c.y, c.x + 1, c.y + 1}}, cells_);
}

CellBox OccupancyGrid::knownBox() const {
  constexpr int kFar = std::numeric_limits<int>::max();
  CellBox box{kFar, kFar, -kFar, -kFar};
  cells_.forEachPacked([&](int tx, int ty, const EvidenceTile& tile) {
    BoxOfBits known;
    for (int y = 0; y < kTileCells; ++y) known.add(y, tile.freeRow(y) | tile.occupiedRow(y));
    if (known.empty()) return;
    const CellBox here = known.inTile(tx, ty);
    box = {std::min(box.x0, here.x0), std::min(box.y0, here.y0), std::max(box.x1, here.x1),
           std::max(box.y1, here.y1)};
  });
  return box.x0 == kFar ? CellBox{} : box;
}

void OccupancyGrid::clear(const mrpt::math::TPoint2D& origin) {
  cells_.clear();
  field_.clear();
  origin_ = origin;
}

}  // namespace ariadne::grid
