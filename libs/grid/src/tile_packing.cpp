#include "tile_packing.h"

#include <algorithm>

#include "bits.h"
#include "row_lanes.h"

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

EvidenceTileRef pack(const EvidencePlane::Cells& cells, const FreeCounts& counts) {
  int highest = 0;
  int apart = 0;
  for (const std::int8_t v : cells) {
    const int count = counts.countOf(v);
    apart += count == FreeCounts::kNone;
    highest |= count == FreeCounts::kNone ? 0 : count;
  }
  if (apart == 0 && std::all_of(cells.begin(), cells.end(), [&](auto v) { return v == cells[0]; }))
    return EvidenceTileRef::shared(counts.countOf(cells[0]));
  int planes = 0;
  while (highest >> planes != 0) ++planes;
  EvidenceTileRef packed;
  EvidenceTile& tile = packed.write(planes, apart);
  for (int y = 0; y < kTileCells; ++y)
    for (int x = 0; x < kTileCells; ++x) {
      const std::int8_t v = cells[tileOffset(x, y)];
      const int count = counts.countOf(v);
      if (count == FreeCounts::kNone)
        tile.setApart(x, y, v);
      else
        for (int k = 0; k < planes; ++k)
          tile.plane(k)[y] |= static_cast<std::uint32_t>(count >> k & 1) << x;
    }
  return packed;
}

}  // namespace ariadne::grid
