// The map of s* as the planner sees it: coarse cells, each with its distances to the nearest wall
// and to the nearest unknown cell.
#pragma once
#include <cstdint>
#include <vector>

#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::explore {

/// What is known of a cell.
enum class CellKind : std::uint8_t { unknown, free, occupied };

/// A coarse picture of the map for planning: per cell whether it is known, and how far walls and
/// the unknown are.
class PlanningGrid {
 public:
  /// A cell is occupied when any of the map's cells in it is, else free when most of them are.
  /// @param cell_m about this side; a whole number of the map's cells is taken, at least one
  /// @param obstacles points that are occupied whatever the map says, m, map frame
  PlanningGrid(const grid::OccupancyGrid& map, double cell_m,
               const std::vector<mrpt::math::TPoint2D>& obstacles);

  /// Cells from west to east.
  int width() const { return width_; }
  /// Cells from south to north.
  int height() const { return height_; }
  /// Number of cells; indices go row by row from the south-west.
  int size() const { return width_ * height_; }
  /// Side of a cell, m.
  double cell_m() const { return cell_m_; }

  /// Index of the cell of a point (m, map frame); -1 outside.
  int indexOf(const mrpt::math::TPoint2D& p) const;
  /// m, map frame.
  mrpt::math::TPoint2D centreOf(int cell) const;
  /// The outermost cells are unknown, so that the neighbours of any other cell are within bounds.
  CellKind kind(int cell) const { return kinds_[cell]; }
  /// Distances from centre to centre, m; up to 6 % too long or 4 % too short (chamfer 3-4).
  double wallDistance(int cell) const { return wall_[cell] * unit_m_; }
  /// To the nearest unknown cell, m.
  double unknownDistance(int cell) const { return unknown_[cell] * unit_m_; }
  /// Whether no occupied cell is on the line between the two cells' centres, ends apart.
  bool sees(int from, int to) const;

 private:
  void classify(const grid::OccupancyGrid& map, int factor);
  std::vector<std::uint16_t> distancesTo(CellKind kind) const;

  int width_ = 0;
  int height_ = 0;
  double cell_m_ = 0;
  double unit_m_ = 0;            // of the distances
  mrpt::math::TPoint2D corner_;  // of cell 0
  grid::Cell first_;             // the map's cell at that corner
  std::vector<CellKind> kinds_;
  std::vector<std::uint16_t> wall_;
  std::vector<std::uint16_t> unknown_;
};

}  // namespace ariadne::explore
