#include "ariadne/grid/tiles/evidence_plane.h"

#include <algorithm>

#include "tiles/free_addition.h"
#include "tiles/tile_packing.h"

namespace ariadne::grid {

std::int8_t EvidencePlane::at(int x, int y) const {
  const EvidenceTile* t = tile(x >> kTileBits, y >> kTileBits);
  return t ? t->at(x & (kTileCells - 1), y & (kTileCells - 1), *counts_) : std::int8_t{0};
}

void EvidencePlane::set(int x, int y, std::int8_t log_odds) {
  setIn(tiles_.at(x >> kTileBits, y >> kTileBits), x & (kTileCells - 1), y & (kTileCells - 1),
        log_odds);
}

/// Cell (x, y) of the tile behind the handle.
void EvidencePlane::setIn(EvidenceTileRef& handle, int x, int y, std::int8_t log_odds) const {
  const int count = counts_->countOf(log_odds);
  const EvidenceTile* const now = handle.get();
  const int apart_now = now ? now->apartCount() : 0;
  if (count == FreeCounts::kNone) {
    const bool is_apart = now && now->isApart(x, y);
    handle.write(0, is_apart ? apart_now : apart_now + 1).setApart(x, y, log_odds);
    return;
  }
  int planes = 0;
  while (count >> planes != 0) ++planes;
  EvidenceTile& tile = handle.write(planes, apart_now);
  if (tile.isApart(x, y)) tile.dropApart(x, y);
  tile.setCount(x, y, count);
}

void EvidencePlane::addHits(const std::vector<Cell>& cells, std::int8_t occupied,
                            std::vector<Cell>& turned) {
  int tx = 0;
  int ty = 0;
  const EvidenceTileRef* handle = nullptr;
  EvidenceTileRef* own = nullptr;  // the same once it was written to
  bool looked = false;
  for (const Cell cell : cells) {
    if (!looked || tx != cell.x >> kTileBits || ty != cell.y >> kTileBits) {
      tx = cell.x >> kTileBits;
      ty = cell.y >> kTileBits;
      handle = tiles_.find(tx, ty);
      own = nullptr;
      looked = true;
    }
    const int x = cell.x & (kTileCells - 1);
    const int y = cell.y & (kTileCells - 1);
    const EvidenceTile* tile = handle ? handle->get() : nullptr;
    const int before = tile ? tile->at(x, y, *counts_) : 0;
    const int after = std::max(before - occupied, int{kMostOccupied});
    if (before == after) continue;
    if (!own) handle = own = &tiles_.at(tx, ty);
    setIn(*own, x, y, static_cast<std::int8_t>(after));
    if (before >= 0 && after < 0) turned.push_back(cell);
  }
}

void EvidencePlane::prefetch(int tx, int ty) const {
  constexpr int kCacheLine = 64;
  constexpr int kCounts = 16 + 4 * 128;  // what most tiles take
  if (const auto* memory = reinterpret_cast<const char*>(tile(tx, ty)))
    for (int i = 0; i < kCounts; i += kCacheLine) __builtin_prefetch(memory + i);
}

void EvidencePlane::addFree(int tx, int ty, const TileMask& free, std::vector<CellBox>& freed) {
  const EvidenceTile* now = tile(tx, ty);
  const bool full = free.full();
  const int shared = now ? now->sharedCount() : 0;
  if (full && shared >= 0) {  // no cell is touched
    const int count = std::min(shared + 1, counts_->most());
    if (!now || count != shared) tiles_.at(tx, ty) = EvidenceTileRef::shared(count);
    return;
  }
  if (!now) {
    std::copy(free.rows.begin(), free.rows.end(), tiles_.at(tx, ty).write(1, 0).plane(0));
    return;
  }
  const FreeAddition addition(*now, free, *counts_);
  if (!addition.changesAny()) return;
  EvidenceTileRef& handle = tiles_.at(tx, ty);
  const BoxOfBits box = addition.write(handle);
  if (!box.empty()) freed.push_back(box.inTile(tx, ty));
  if (full && holdsOnlyMostFree(*handle.get(), *counts_))
    handle = EvidenceTileRef::shared(counts_->most());
}

EvidencePlane::Cells EvidencePlane::cellsOf(const EvidenceTile& tile) const {
  Cells cells;
  unpack(tile, *counts_, cells);
  return cells;
}

void EvidencePlane::setCells(int tx, int ty, const Cells& cells) {
  tiles_.at(tx, ty) = pack(cells, *counts_);
}

}  // namespace ariadne::grid
