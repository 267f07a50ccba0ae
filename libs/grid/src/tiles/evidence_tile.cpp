#include "ariadne/grid/tiles/evidence_tile.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <vector>

#include "ariadne/grid/tiles/tile_pool.h"
#include "tiles/bits.h"

namespace ariadne::grid {
namespace {

constexpr std::size_t kPlaneBytes = kTileCells * sizeof(std::uint32_t);
constexpr int kRoomStep = 16;  // cells apart that room is made for at a time

int roomFor(int apart) { return (apart + kRoomStep - 1) / kRoomStep * kRoomStep; }

}  // namespace

std::size_t EvidenceTile::bytesFor(int planes, int capacity) {
  const std::size_t apart =
      capacity > 0 ? kPlaneBytes + kTileCells * sizeof(std::uint16_t) + capacity : 0;
  return sizeof(EvidenceTile) + planes * kPlaneBytes + apart;
}

int EvidenceTile::apartIndex(int x, int y) const {
  return apartBegin()[y] + countBits(apart()[y] & ((1U << x) - 1));
}

std::int8_t EvidenceTile::at(int x, int y, const FreeCounts& counts) const {
  if (isApart(x, y)) return apartValues()[apartIndex(x, y)];
  int count = 0;
  for (int k = 0; k < planes_; ++k) count |= static_cast<int>(plane(k)[y] >> x & 1U) << k;
  return counts.logOdds(count);
}

EvidenceTile::ApartRow EvidenceTile::apartRow(int y) const {
  ApartRow row;
  const std::int8_t* value = apartValues() + apartBegin()[y];
  forEachBit(apart()[y], [&](int x) {
    row.free |= static_cast<std::uint32_t>(*value > 0) << x;
    row.occupied |= static_cast<std::uint32_t>(*value++ < 0) << x;
  });
  return row;
}

void EvidenceTile::setCount(int x, int y, int count) {
  for (int k = 0; k < planes_; ++k) {
    std::uint32_t& word = plane(k)[y];
    word = (word & ~(1U << x)) | static_cast<std::uint32_t>(count >> k & 1) << x;
  }
}

void EvidenceTile::setApart(int x, int y, std::int8_t log_odds) {
  std::int8_t* value = apartValues() + apartIndex(x, y);
  if (!isApart(x, y)) {
    std::memmove(value + 1, value, static_cast<std::size_t>(apartValues() + apart_count_ - value));
    ++apart_count_;
    setCount(x, y, 0);
    apartForWriting()[y] |= 1U << x;
    for (int row = y + 1; row < kTileCells; ++row) ++beginForWriting()[row];
  }
  *value = log_odds;
}

void EvidenceTile::dropApart(int x, int y) {
  std::int8_t* value = apartValues() + apartIndex(x, y);
  std::memmove(value, value + 1,
               static_cast<std::size_t>(apartValues() + apart_count_ - value - 1));
  --apart_count_;
  apartForWriting()[y] &= ~(1U << x);
  for (int row = y + 1; row < kTileCells; ++row) --beginForWriting()[row];
}

void EvidenceTile::appendApart(int y, std::uint32_t cells, const std::int8_t* row) {
  apartForWriting()[y] = cells;
  beginForWriting()[y] = apart_count_;
  forEachBit(cells, [&](int x) { apartValues()[apart_count_++] = row[x]; });
}

EvidenceTileRef EvidenceTileRef::make(int planes, int apart) {
  const int room = roomFor(apart);
  const std::size_t bytes = EvidenceTile::bytesFor(planes, room);
  auto* tile = new (TilePool::take(bytes)) EvidenceTile(planes, room);
  std::memset(tile->words(), 0, bytes - sizeof(EvidenceTile));
  return EvidenceTileRef(tile);
}

const EvidenceTileRef& EvidenceTileRef::shared(int count) {
  static const auto tiles = [] {
    std::vector<EvidenceTileRef> all;
    for (int n = 0; n <= kMostFree; ++n) {
      int planes = 0;
      while (n >> planes != 0) ++planes;
      all.push_back(make(planes, 0));
      for (int k = 0; k < planes; ++k)
        std::fill_n(all[n].tile_->plane(k), kTileCells, (n >> k & 1) != 0 ? ~0U : 0U);
      all[n].tile_->shared_count_ = static_cast<std::int16_t>(n);
    }
    return all;
  }();
  return tiles[static_cast<std::size_t>(count)];
}

EvidenceTile& EvidenceTileRef::write(int planes, int apart) {
  if (!tile_) {
    *this = make(planes, apart);
    return *tile_;
  }
  // Another thread may let go meanwhile; then the copy was not needed, and no harm is done.
  const bool alone = tile_->holders_.load(std::memory_order_acquire) == 1;
  if (alone && planes <= tile_->planes_ && apart <= tile_->capacity_) return *tile_;
  const EvidenceTile& old = *tile_;
  EvidenceTileRef copy =
      make(std::max<int>(planes, old.planes_), std::max<int>(apart, old.apart_count_));
  EvidenceTile& tile = *copy.tile_;
  std::memcpy(tile.words(), old.words(), old.planes_ * kPlaneBytes);
  if (old.apart_count_ > 0) {
    tile.apart_count_ = old.apart_count_;
    std::memcpy(tile.apartForWriting(), old.apart(), kPlaneBytes);
    std::memcpy(tile.beginForWriting(), old.apartBegin(), kTileCells * sizeof(std::uint16_t));
    std::memcpy(tile.apartValues(), old.apartValues(), old.apart_count_);
  }
  *this = std::move(copy);
  return *tile_;
}

void EvidenceTileRef::destroy() {
  const std::size_t bytes = tile_->bytes();
  tile_->~EvidenceTile();
  TilePool::give(tile_, bytes);
}

}  // namespace ariadne::grid
