// Many scans on their way into one grid. A cell that n scans saw free gets n times the evidence in
// one go: the scans are counted in planes of bits, 32 cells to a word, and a tile's own cells are
// touched every 31st scan, where a beam ended, and at the end.
#pragma once
#include <vector>

#include "ariadne/grid/tiles/evidence_plane.h"
#include "ariadne/grid/tiles/log_odds.h"
#include "insertion/scan_raster.h"

namespace ariadne::grid {

class ScanBatch {
 public:
  /// Tiles that one batch may span: 16 MB of index, 1.6 km by 1.6 km at 0.05 m.
  static constexpr std::size_t kMostTiles = 1 << 20;

  /// Starts anew on a plane, which must not change until finish().
  void begin(const EvidencePlane& cells, BeamEvidence evidence);
  /// Counts one scan. False, and nothing done, when the batch would span over kMostTiles with it
  /// and holds others already.
  bool add(const ScanRaster& scan);
  /// Writes what changed to the plane that begin() was given. Tiles that hold what they held stay
  /// shared. Appends, tile by tile, the box of the cells that turned occupied or ceased to be.
  void finish(EvidencePlane& cells, std::vector<CellBox>& changed);

 private:
  static constexpr int kPlanes = 5;
  static constexpr int kMostCounted = (1 << kPlanes) - 1;

  /// Four rows' bits of each plane: one register each, and all that a hit cell needs in 80 bytes.
  struct alignas(16) RowCounts {
    std::uint32_t planes[kPlanes][4];
  };
  struct OpenTile {
    alignas(16) EvidencePlane::Cells cells;  // before the counted scans
    std::array<RowCounts, kTileCells / 4> counts;
    int counted = 0;
    int tx = 0;
    int ty = 0;
    const EvidenceTile* before = nullptr;
  };

  bool cover(const CellBox& box);
  OpenTile& tileAt(int tx, int ty);
  void count(OpenTile& tile, const TileMask& free);
  void hit(Cell cell);
  void settle(OpenTile& tile) const;

  const EvidencePlane* plane_ = nullptr;
  BeamEvidence evidence_;
  CellBox box_;                       // of the index, in tile coordinates
  std::vector<std::uint32_t> index_;  // open tile, 0 for none
  std::vector<OpenTile> tiles_;       // kept from batch to batch: its memory is costly to get
  std::uint32_t used_ = 1;
};

}  // namespace ariadne::grid
