#include "tiles/free_addition.h"

#include <algorithm>

#include "tiles/bits.h"
#include "tiles/lanes.h"

namespace ariadne::grid {
namespace {

/// The planes of a tile's counts, four rows at a time.
class Planes {
 public:
  Planes(const EvidenceTile& tile, int most) : words_(tile.plane(0)), count_(tile.planes()) {
    for (int k = 0; k < count_; ++k)
      unlike_most_[k] = Lanes{} - (~static_cast<std::uint32_t>(most) >> k & 1U);
  }
  /// Of `cells` those whose count is `most`. There must be as many planes as that needs.
  Lanes mostOf(Lanes cells, int i) const {
    for (int k = 0; k < count_; ++k) cells &= lanes(words_, k * kLanes + i) ^ unlike_most_[k];
    return cells;
  }
  /// Of `cells` those whose count would need another plane.
  Lanes overflowOf(Lanes cells, int i) const {
    for (int k = 0; k < count_; ++k) cells &= lanes(words_, k * kLanes + i);
    return cells;
  }

 private:
  const std::uint32_t* words_;
  int count_;
  Lanes unlike_most_[7];  // all bits where most has none
};

/// Whether a cell apart becomes kMostFree when it is seen free once more.
bool apartBecomesMost(const EvidenceTile& tile, int amount) {
  const std::int8_t* values = tile.apartValues();
  return std::any_of(values, values + tile.apartCount(),
                     [&](std::int8_t v) { return v + amount >= kMostFree; });
}

}  // namespace

FreeAddition::FreeAddition(const EvidenceTile& tile, const TileMask& free, const FreeCounts& counts)
    : counts_(counts), planes_(tile.planes()) {
  const Planes planes(tile, counts.most());
  const std::uint32_t* const apart = tile.apartCount() > 0 ? tile.apart() : nullptr;
  const bool may_be_most = tile.planes() == counts.planes();
  Lanes counted_any{};
  Lanes apart_any{};
  Lanes overflow{};
  for (int i = 0; i < kLanes; ++i) {
    Lanes counted = lanes(free.rows.data(), i);
    if (apart) {
      const Lanes touched = counted & lanes(apart, i);
      lanes(apart_.data(), i) = touched;
      apart_any |= touched;
      counted &= ~touched;
    }
    if (may_be_most)
      counted ^= planes.mostOf(counted, i);
    else
      overflow |= planes.overflowOf(counted, i);
    lanes(counted_.data(), i) = counted;
    counted_any |= counted;
  }
  counted_any_ = any(counted_any);
  apart_any_ = any(apart_any);
  if (any(overflow)) ++planes_;
  if (apart_any_ && apartBecomesMost(tile, counts.amount())) planes_ = counts.planes();
}

BoxOfBits FreeAddition::write(EvidenceTileRef& handle) const {
  EvidenceTile& tile = handle.write(planes_, handle.get()->apartCount());
  std::uint32_t* const words = tile.plane(0);
  const int planes = tile.planes();
  for (int i = 0; i < kLanes; ++i) {
    Lanes carry = lanes(counted_.data(), i);
    for (int k = 0; k < planes; ++k) {  // a ripple of carries
      Lanes& bits = lanes(words, k * kLanes + i);
      const Lanes sum = bits ^ carry;
      carry &= bits;
      bits = sum;
    }
  }
  return apart_any_ ? addApart(tile) : BoxOfBits();
}

BoxOfBits FreeAddition::addApart(EvidenceTile& tile) const {
  BoxOfBits freed;
  for (int y = 0; y < kTileCells; ++y) {
    if (apart_[y] == 0) continue;
    std::uint32_t freed_row = 0;
    std::uint32_t most_row = 0;
    std::int8_t* value = tile.apartValues() + tile.apartBegin()[y];
    forEachBit(tile.apart()[y], [&](int x) {
      std::int8_t& v = *value++;
      if ((apart_[y] >> x & 1U) == 0) return;
      const int sum = std::min(v + counts_.amount(), int{kMostFree});
      freed_row |= static_cast<std::uint32_t>(v < 0 && sum >= 0) << x;
      most_row |= static_cast<std::uint32_t>(sum == kMostFree) << x;
      v = static_cast<std::int8_t>(sum);
    });
    // What is as free as can be is counted again, so that the tile may become the shared one.
    forEachBit(most_row, [&](int x) {
      tile.dropApart(x, y);
      tile.setCount(x, y, counts_.most());
    });
    freed.add(y, freed_row);
  }
  return freed;
}

bool holdsOnlyMostFree(const EvidenceTile& tile, const FreeCounts& counts) {
  if (tile.apartCount() > 0 || tile.planes() != counts.planes()) return false;
  const Planes planes(tile, counts.most());
  for (int i = 0; i < kLanes; ++i)
    if (any(~planes.mostOf(~Lanes{}, i))) return false;
  return true;
}

}  // namespace ariadne::grid
