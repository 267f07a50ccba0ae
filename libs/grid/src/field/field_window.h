// Rows of one tile of the likelihood field, made anew from the occupied cells about them: first
// along each row, then across the rows.
#pragma once
#include <vector>

#include "ariadne/grid/field/likelihood_field.h"
#include "ariadne/grid/tiles/evidence_plane.h"

namespace ariadne::grid {

class FieldWindow {
 public:
  /// Rows [y0, y1) of cells, within tile row ty.
  void build(const FieldKernel& kernel, const EvidencePlane& log_odds, int tx, int ty, int y0,
             int y1);
  /// The kTileCells values of row y.
  const std::uint8_t* row(int y) const { return field_[y & (kTileCells - 1)].v; }

 private:
  struct alignas(16) Row {
    std::uint8_t v[kTileCells];
  };
  bool findOccupied(int y);
  void spread(const FieldKernel& kernel, Row& out) const;
  void combine(const FieldKernel& kernel, int y, Row& out) const;

  int first_row_ = 0;                       // first of spread_
  std::vector<const EvidenceTile*> tiles_;  // of the tile row in work
  std::vector<std::uint32_t> rows_;         // occupied cells of the row in work, tile by tile
  std::vector<std::uint32_t> reach_;        // which columns of each of them are near enough
  std::vector<std::uint8_t> occupied_;      // 255 on the occupied cells of the row in work
  std::vector<Row> spread_;  // the field of each row's own occupied cells, at that row
  std::vector<char> any_;    // whether there are any
  Row field_[kTileCells];
};

}  // namespace ariadne::grid
