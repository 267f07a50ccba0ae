// One tile of log odds, packed without loss. Most cells were only ever seen free: how often is
// counted in planes of bits, 32 cells to a word, as many planes as the highest count needs. Other
// cells, mostly where beams ended, stand apart with a byte each. A tile takes 0.1 to 0.7 KB instead
// of 1, and evidence for free is added to 128 cells at a time.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "ariadne/grid/tiles/free_counts.h"
#include "ariadne/grid/tiles/tiled_plane.h"

namespace ariadne::grid {

/// Lives behind an EvidenceTileRef only: its words and bytes follow it in memory.
class alignas(16) EvidenceTile {
 public:
  EvidenceTile(const EvidenceTile&) = delete;
  EvidenceTile& operator=(const EvidenceTile&) = delete;

  /// Planes of bits that hold the counts: enough for the highest one.
  int planes() const { return planes_; }
  /// Word y: bit k of the counts of row y, bit x for cell (x, y); 0 for a cell apart.
  const std::uint32_t* plane(int k) const { return words() + k * kTileCells; }
  /// As above, to be written by who holds the tile alone.
  std::uint32_t* plane(int k) { return words() + k * kTileCells; }

  /// Whether there may be cells apart; the functions below are for such tiles.
  bool hasApart() const { return capacity_ > 0; }
  /// Cells apart: those in which a beam ended.
  int apartCount() const { return apart_count_; }
  /// Whether a cell has a byte of its own.
  bool isApart(int x, int y) const { return hasApart() && (apart()[y] >> x & 1U) != 0; }
  /// Cells apart: bit x of word y.
  const std::uint32_t* apart() const { return plane(planes_); }
  /// Log odds of the cells apart, row by row; row y's begin at apartBegin()[y].
  const std::int8_t* apartValues() const {
    return reinterpret_cast<const std::int8_t*>(apartBegin() + kTileCells);
  }
  /// To be written by who holds the tile alone.
  std::int8_t* apartValues() {
    return reinterpret_cast<std::int8_t*>(beginForWriting() + kTileCells);
  }
  /// Per row, the index in apartValues() of its first cell apart.
  const std::uint16_t* apartBegin() const {
    return reinterpret_cast<const std::uint16_t*>(plane(planes_ + 1));
  }

  /// Log odds of a cell of the tile.
  std::int8_t at(int x, int y, const FreeCounts& counts) const;
  /// Bit x: cell (x, y) is free (over 0), is occupied (under 0).
  std::uint32_t freeRow(int y) const {
    std::uint32_t row = 0;
    for (int k = 0; k < planes_; ++k) row |= plane(k)[y];
    return hasApart() && apart()[y] != 0 ? row | apartRow(y).free : row;
  }
  /// Bit x: cell (x, y) is occupied.
  std::uint32_t occupiedRow(int y) const {
    return hasApart() && apart()[y] != 0 ? apartRow(y).occupied : 0;
  }

  /// The count of all cells when this is the tile that all maps share for it, else -1.
  int sharedCount() const { return shared_count_; }
  /// Memory that the tile takes.
  std::size_t bytes() const { return bytesFor(planes_, capacity_); }

  /// Editing is for a tile from EvidenceTileRef::write(). The count must fit the planes.
  void setCount(int x, int y, int count);
  /// There must be room for the cell.
  void setApart(int x, int y, std::int8_t log_odds);
  /// Its count becomes 0.
  void dropApart(int x, int y);
  /// Row y's cells apart, of a new tile and after those of the rows before; the counts of `cells`
  /// must be 0. Takes row[x] for each bit x.
  void appendApart(int y, std::uint32_t cells, const std::int8_t* row);

 private:
  friend class EvidenceTileRef;
  EvidenceTile(int planes, int capacity)
      : capacity_(static_cast<std::uint16_t>(capacity)),
        planes_(static_cast<std::uint8_t>(planes)) {}
  static std::size_t bytesFor(int planes, int capacity);
  int apartIndex(int x, int y) const;
  struct ApartRow {
    std::uint32_t free = 0;
    std::uint32_t occupied = 0;
  };
  ApartRow apartRow(int y) const;
  const std::uint32_t* words() const { return reinterpret_cast<const std::uint32_t*>(this + 1); }
  std::uint32_t* words() { return reinterpret_cast<std::uint32_t*>(this + 1); }
  std::uint32_t* apartForWriting() { return plane(planes_); }
  std::uint16_t* beginForWriting() { return reinterpret_cast<std::uint16_t*>(plane(planes_ + 1)); }

  std::atomic<std::int32_t> holders_{1};
  std::int16_t shared_count_ = -1;
  std::uint16_t apart_count_ = 0;
  std::uint16_t capacity_;  // cells apart that there is room for
  std::uint8_t planes_;
};

/// Shares a tile when copied (one increment). Different holders may be used from different threads
/// at once; one holder may not.
class EvidenceTileRef {
 public:
  EvidenceTileRef() = default;
  /// Shares the tile: one atomic increment.
  EvidenceTileRef(const EvidenceTileRef& other) : tile_(other.tile_) {
    if (tile_) tile_->holders_.fetch_add(1, std::memory_order_relaxed);
  }
  /// Takes the tile over; `other` is empty then.
  EvidenceTileRef(EvidenceTileRef&& other) noexcept : tile_(std::exchange(other.tile_, nullptr)) {}
  /// By swap.
  EvidenceTileRef& operator=(EvidenceTileRef other) noexcept {
    std::swap(tile_, other.tile_);
    return *this;
  }
  ~EvidenceTileRef() {
    if (tile_ && tile_->holders_.fetch_sub(1, std::memory_order_acq_rel) == 1) destroy();
  }

  /// A tile of zeros with room.
  static EvidenceTileRef make(int planes, int apart);
  /// The tile of one count that all maps share; it takes no memory of theirs.
  static const EvidenceTileRef& shared(int count);

  /// Null before the first write().
  const EvidenceTile* get() const { return tile_; }
  /// The tile for writing: of this holder alone, with at least so many planes (new ones are 0) and
  /// room for so many cells apart.
  EvidenceTile& write(int planes, int apart);

 private:
  explicit EvidenceTileRef(EvidenceTile* tile) : tile_(tile) {}
  void destroy();
  EvidenceTile* tile_ = nullptr;
};

}  // namespace ariadne::grid
