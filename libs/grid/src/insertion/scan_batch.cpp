#include "insertion/scan_batch.h"

#include <algorithm>
#include <cstring>

#include "tiles/row_lanes.h"

namespace ariadne::grid {
namespace {

CellBox joined(const CellBox& a, const CellBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Box of the cells that are occupied before or after only.
BoxOfBits occupancyChange(const EvidenceTile* before, const EvidencePlane::Cells& after) {
  BoxOfBits box;
  for (int y = 0; y < kTileCells; ++y)
    box.add(y, (before ? before->occupiedRow(y) : 0) ^ occupiedOf(&after[tileOffset(0, y)]));
  return box;
}

}  // namespace

void ScanBatch::begin(const EvidencePlane& cells, BeamEvidence evidence) {
  plane_ = &cells;
  evidence_ = evidence;
  box_ = {};
  index_.clear();
  used_ = 1;
}

bool ScanBatch::add(const ScanRaster& scan) {
  if (!cover(scan.tileBox())) return false;
  scan.forEachTile([this](int tx, int ty, const TileMask& free) { count(tileAt(tx, ty), free); });
  for (const Cell cell : scan.hits()) hit(cell);
  return true;
}

/// Widens the index to the box, by a third more than is asked for: a robot drives on.
bool ScanBatch::cover(const CellBox& box) {
  const CellBox all = joined(box_, box);
  if (all.x0 == box_.x0 && all.y0 == box_.y0 && all.x1 == box_.x1 && all.y1 == box_.y1) return true;
  const int dx = (all.x1 - all.x0) / 3;
  const int dy = (all.y1 - all.y0) / 3;
  const CellBox wide{all.x0 - dx, all.y0 - dy, all.x1 + dx, all.y1 + dy};
  const auto width = static_cast<std::size_t>(wide.x1 - wide.x0);
  const std::size_t size = width * static_cast<std::size_t>(wide.y1 - wide.y0);
  if (size > kMostTiles && !box_.empty()) return false;
  box_ = wide;
  index_.assign(size, 0);
  for (std::uint32_t i = 1; i < used_; ++i)
    index_[static_cast<std::size_t>(tiles_[i].ty - box_.y0) * width + (tiles_[i].tx - box_.x0)] = i;
  return true;
}

ScanBatch::OpenTile& ScanBatch::tileAt(int tx, int ty) {
  std::uint32_t& i =
      index_[static_cast<std::size_t>(ty - box_.y0) * (box_.x1 - box_.x0) + (tx - box_.x0)];
  if (i == 0) {
    if (used_ >= tiles_.size()) tiles_.resize(std::max<std::size_t>(64, 2 * tiles_.size()));
    i = used_++;
    OpenTile& tile = tiles_[i];
    tile.before = plane_->tile(tx, ty);
    if (tile.before)
      tile.cells = plane_->cellsOf(*tile.before);
    else
      tile.cells.fill(0);
    tile.counts = {};
    tile.counted = 0;
    tile.tx = tx;
    tile.ty = ty;
  }
  return tiles_[i];
}

/// One more for each of the cells: a ripple of carries through the planes.
void ScanBatch::count(OpenTile& tile, const TileMask& free) {
  if (tile.counted == kMostCounted) settle(tile);
  ++tile.counted;
  const std::uint32_t* rows = free.rows.data();
  for (RowCounts& counts : tile.counts) {
    std::uint32_t carry[4] = {rows[0], rows[1], rows[2], rows[3]};
    for (auto& plane : counts.planes)
      for (int y = 0; y < 4; ++y) {
        const std::uint32_t sum = plane[y] ^ carry[y];
        carry[y] &= plane[y];
        plane[y] = sum;
      }
    rows += 4;
  }
}

/// A beam ended in the cell: the free evidence so far comes first, since both saturate.
void ScanBatch::hit(Cell cell) {
  OpenTile& tile = tileAt(cell.x >> kTileBits, cell.y >> kTileBits);
  const int y = cell.y & (kTileCells - 1);
  const int x = cell.x & (kTileCells - 1);
  int count = 0;
  for (int k = 0; k < kPlanes; ++k) {
    std::uint32_t& row = tile.counts[y / 4].planes[k][y % 4];
    count |= static_cast<int>(row >> x & 1U) << k;
    row &= ~(1U << x);
  }
  std::int8_t& value = tile.cells[tileOffset(x, y)];
  const int before = std::min(value + count * evidence_.free, int{kMostFree});
  value = static_cast<std::int8_t>(std::max(before - evidence_.occupied, int{kMostOccupied}));
}

/// Adds what was counted to the cells. A plane may stand for more than a cell holds, up to 127
/// times 16: it is added in parts, of which three fill any cell.
void ScanBatch::settle(OpenTile& tile) const {
  for (int k = 0; k < kPlanes; ++k) {
    std::uint32_t any = 0;
    for (const RowCounts& counts : tile.counts)
      for (const std::uint32_t row : counts.planes[k]) any |= row;
    if (any == 0) continue;
    int amount = evidence_.free << k;
    for (int part = 0; part < 3 && amount > 0; ++part, amount -= kMostFree) {
      const FreeLanes lanes(static_cast<std::int8_t>(std::min(amount, int{kMostFree})));
      for (int y = 0; y < kTileCells; ++y)
        if (const std::uint32_t cells = tile.counts[y / 4].planes[k][y % 4])
          lanes.add(&tile.cells[tileOffset(0, y)], cells);
    }
  }
  tile.counts = {};
  tile.counted = 0;
}

void ScanBatch::finish(EvidencePlane& cells, std::vector<CellBox>& changed) {
  for (std::uint32_t i = 1; i < used_; ++i) {
    OpenTile& tile = tiles_[i];
    settle(tile);
    if (tile.before && cells.cellsOf(*tile.before) == tile.cells) continue;
    const BoxOfBits box = occupancyChange(tile.before, tile.cells);
    if (!box.empty()) changed.push_back(box.inTile(tile.tx, tile.ty));
    cells.setCells(tile.tx, tile.ty, tile.cells);
  }
  begin(cells, evidence_);
}

}  // namespace ariadne::grid
