#include "tiles/tile_packing.h"

#include <algorithm>

#include "tiles/bits.h"
#include "tiles/row_lanes.h"

namespace ariadne::grid {

void unpack(const EvidenceTile& tile, const FreeCounts& counts, EvidencePlane::Cells& cells) {
  alignas(16) EvidencePlane::Cells rows{};
  for (int k = 0; k < tile.planes(); ++k) {
    // Sums saturate at kMostFree, as log odds do.
    const FreeLanes lanes(static_cast<std::int8_t>(std::min(counts.amount() << k, int{kMostFree})));
    for (int y = 0; y < kTileCells; ++y) lanes.add(&rows[tileOffset(0, y)], tile.plane(k)[y]);
  }
  if (tile.hasApart()) {
    const std::int8_t* value = tile.apartValues();
    for (int y = 0; y < kTileCells; ++y)
      forEachBit(tile.apart()[y], [&](int x) { rows[tileOffset(x, y)] = *value++; });
  }
  cells = rows;
}

namespace {

using Counts = std::array<std::uint8_t, kTileCells * kTileCells>;

/// Bit k of 32 counts, the first one's lowest.
std::uint32_t bitsOf(const std::uint8_t* counts, int k) {
  std::uint32_t bits = 0;
  for (int x = 0; x < kTileCells; x += 8) {
    std::uint64_t eight = 0;
    for (int i = 0; i < 8; ++i) eight |= std::uint64_t{counts[x + i]} << 8 * i;
    // Byte i's bit, times 2^(56 - 7 i), is bit 56 + i.
    const std::uint64_t sum = (eight >> k & 0x0101010101010101U) * 0x0102040810204080U;
    bits |= static_cast<std::uint32_t>(sum >> 56) << x;
  }
  return bits;
}

int bitWidth(int v) {
  int bits = 0;
  while (v >> bits != 0) ++bits;
  return bits;
}

}  // namespace

EvidenceTileRef pack(const EvidencePlane::Cells& cells, const FreeCounts& counts) {
  Counts count;
  std::array<std::uint32_t, kTileCells> apart{};
  int highest = 0;
  int apart_count = 0;
  for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
    const int c = counts.countOf(cells[i]);
    const bool is_apart = c == FreeCounts::kNone;
    apart[i / kTileCells] |= static_cast<std::uint32_t>(is_apart) << i % kTileCells;
    apart_count += is_apart;
    count[i] = static_cast<std::uint8_t>(is_apart ? 0 : c);
    highest |= count[i];
  }
  if (apart_count == 0 &&
      std::all_of(count.begin(), count.end(), [&](auto c) { return c == count[0]; }))
    return EvidenceTileRef::shared(count[0]);
  EvidenceTileRef packed;
  EvidenceTile& tile = packed.write(bitWidth(highest), apart_count);
  for (int y = 0; y < kTileCells; ++y) {
    for (int k = 0; k < tile.planes(); ++k) tile.plane(k)[y] = bitsOf(&count[tileOffset(0, y)], k);
    if (apart_count > 0) tile.appendApart(y, apart[y], &cells[tileOffset(0, y)]);
  }
  return packed;
}

}  // namespace ariadne::grid
