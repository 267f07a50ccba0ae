// The field that scans are matched on: 255 exp(-d^2 / 2 sigma^2) of the distance d to the nearest
// occupied cell, kept up to date cell by cell as the map changes (Thrun et al., Probabilistic
// Robotics, 6.4). Tiles without a wall nearby take no memory.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "ariadne/grid/tiled_plane.h"

namespace ariadne::grid {

struct Cell {
  int x = 0;
  int y = 0;
};

/// The square around one occupied cell, (2 radius + 1)^2 values.
class FieldKernel {
 public:
  explicit FieldKernel(double sigma_cells);
  int radius() const { return radius_; }
  std::uint8_t at(int dx, int dy) const { return row(dy)[dx + radius_]; }
  /// Values of row dy from dx = -radius on.
  const std::uint8_t* row(int dy) const { return &values_[(dy + radius_) * (2 * radius_ + 1)]; }

 private:
  int radius_;
  std::vector<std::uint8_t> values_;
};

class LikelihoodField {
 public:
  /// @param sigma_cells width in cells; the field is 0 past 3 sigma.
  explicit LikelihoodField(double sigma_cells);

  std::uint8_t at(int x, int y) const { return plane_.at(x, y); }
  const TiledPlane<std::uint8_t>& plane() const { return plane_; }
  /// Cell (x, y) turned occupied.
  void occupy(Cell cell);
  /// Cell (x, y) is no longer occupied; `log_odds` is the map after the change.
  void release(Cell cell, const TiledPlane<std::int8_t>& log_odds);
  void clear() { plane_.clear(); }

 private:
  /// Raises the part of the plane inside `window` to the kernel about `centre`.
  void stamp(Cell centre, const CellBox& window);

  std::shared_ptr<const FieldKernel> kernel_;
  TiledPlane<std::uint8_t> plane_;
};

}  // namespace ariadne::grid
