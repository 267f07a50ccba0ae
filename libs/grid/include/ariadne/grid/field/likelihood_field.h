// The field that scans are matched on: 255 exp(-d^2 / 2 sigma^2) of the distance d to the nearest
// occupied cell, kept up to date cell by cell as the map changes (Thrun et al., Probabilistic
// Robotics, 6.4). Tiles without a wall nearby take no memory.
//
// The Gaussian is a product of one along x and one along y, so a window is rebuilt in two passes;
// trying every occupied cell near a freed one took a third of a run. Whatever the order of changes,
// the field depends on the set of occupied cells alone.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ariadne/grid/tiles/evidence_plane.h"
#include "ariadne/grid/tiles/tiled_plane.h"

namespace ariadne::grid {

/// The square of values around one occupied cell.
class FieldKernel {
 public:
  /// @param sigma_cells standard deviation of the Gaussian, cells
  explicit FieldKernel(double sigma_cells);
  /// Cells beyond which the kernel is 0.
  int radius() const { return radius_; }
  /// Value `distance` cells away along one axis, 0..255.
  std::uint8_t along(int distance) const { return line_[radius_ + distance]; }
  /// What an occupied cell gives a cell (dx, dy) away.
  std::uint8_t at(int dx, int dy) const { return row(dy)[dx]; }
  /// Pointer to the middle of row dy; past the radius a tile's width of zeros follows on each side.
  const std::uint8_t* row(int dy) const {
    return square_.data() + std::ptrdiff_t{dy + radius_} * stride_ + radius_ + kTileCells;
  }
  /// Rounded product of two values along the axes; 255 stands for 1.
  static constexpr std::uint8_t product(unsigned a, unsigned b) {
    const unsigned t = a * b + 128;
    return static_cast<std::uint8_t>((t + (t >> 8)) >> 8);
  }

 private:
  int radius_;
  int stride_;
  std::vector<std::uint8_t> line_;
  std::vector<std::uint8_t> square_;
};

/// At each cell how near the next occupied cell is, 0 to 255, as a Gaussian of the distance; kept
/// up to date as cells change.
class LikelihoodField {
 public:
  /// Low tiles: along a wall most of a high one is 0, which takes no memory here.
  using Plane = TiledPlane<std::uint8_t, 3>;

  /// @param sigma_cells width in cells; the field is 0 past 3 sigma.
  explicit LikelihoodField(double sigma_cells);

  /// 0 far from any wall, 255 in an occupied cell.
  std::uint8_t at(int x, int y) const { return plane_.at(x, y); }
  /// The cells themselves.
  const Plane& plane() const { return plane_; }
  /// Cell (x, y) turned occupied.
  void occupy(Cell cell);
  /// Any cells in these boxes turned occupied or ceased to be; `log_odds` is the map after it all.
  void update(const std::vector<CellBox>& changed, const EvidencePlane& log_odds);
  /// No cell is occupied.
  void clear() { plane_.clear(); }

 private:
  void stamp(Cell cell, int tx, int ty);
  void replaceRows(int tx, int y0, int y1, const std::uint8_t* rows);
  std::shared_ptr<const FieldKernel> kernel_;
  Plane plane_;
};

}  // namespace ariadne::grid
