// The occupancy grid of one particle: log odds and likelihood field, both in copy-on-write tiles.
// A copy is two increments; a copy kept aside is a checkpoint of the map as of that moment.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <memory>

#include "ariadne/grid/field/likelihood_field.h"
#include "ariadne/grid/insertion/scan_shape.h"
#include "ariadne/grid/tiles/evidence_plane.h"
#include "ariadne/grid/tiles/log_odds.h"
#include "ariadne/grid/tiles/tiled_plane.h"

namespace ariadne::grid {

/// A scan and where it was taken.
struct PlacedScan {
  const ScanShape* shape = nullptr;  ///< not null; it may be one of many maps' at once
  mrpt::math::TPose2D map_from_robot;
};

/// A map: log odds and likelihood field in tiles that copies share. A copy costs two increments.
class OccupancyGrid {
 public:
  /// Throws core::UsageError when a parameter is out of bounds.
  explicit OccupancyGrid(const GridParams& params = {});

  /// Side of a cell, m.
  double resolution() const { return resolution_; }
  /// Corner of cell (0, 0), m; an imported map may lie off the multiples of the resolution.
  const mrpt::math::TPoint2D& origin() const { return origin_; }
  /// @param p m, map frame
  Cell cellOf(const mrpt::math::TPoint2D& p) const;
  /// m, map frame.
  mrpt::math::TPoint2D centreOf(Cell c) const;

  /// Log odds: over 0 free, under 0 occupied, 0 unknown.
  std::int8_t at(Cell c) const { return cells_.at(c.x, c.y); }
  /// 0..255, 255 on an occupied cell.
  std::uint8_t fieldAt(Cell c) const { return field_.at(c.x, c.y); }
  /// The log odds.
  const EvidencePlane& cells() const { return cells_; }
  /// The likelihood field, 0 to 255.
  const LikelihoodField::Plane& field() const { return field_.plane(); }

  /// Inserts a scan: every cell inside the outline gets the evidence for free once, every cell that
  /// a beam ended in the evidence for occupied once and none for free. All saturate.
  /// Throws core::Error when the pose is not finite or the map would grow past all bounds.
  void insert(const ScanShape& shape, const mrpt::math::TPose2D& map_from_robot);
  /// The same map, cell by cell, as insert() of one scan after the other; much faster where scans
  /// overlap, since what many scans saw free is counted and added at once, and the field is made
  /// once. Throws core::Error when a pose is not finite, and then changes nothing; also when a
  /// shape is not finite or the map would grow past all bounds, and then may hold a part of the
  /// scans.
  void insertMany(const std::vector<PlacedScan>& scans);
  /// Sets one cell; the field follows.
  void set(Cell c, std::int8_t log_odds);

  /// Smallest box with all known cells.
  CellBox knownBox() const;
  /// Forgets everything; the origin becomes `origin`.
  void clear(const mrpt::math::TPoint2D& origin = {0, 0});

 private:
  double resolution_;
  mrpt::math::TPoint2D origin_{0, 0};
  BeamEvidence evidence_;
  EvidencePlane cells_;
  LikelihoodField field_;
};

}  // namespace ariadne::grid
