#include "ariadne/grid/map/occupancy_grid.h"
#include "insertion/scan_batch.h"

namespace ariadne::grid {
namespace {

/// Buffers that a thread keeps from map to map.
struct ManyScratch {
  std::vector<CellsFromRobot> places;
  ScanRaster raster;
  ScanBatch batch;
  std::vector<CellBox> changed;
};

}  // namespace

void OccupancyGrid::insertMany(const std::vector<PlacedScan>& scans) {
  static thread_local ManyScratch scratch;
  scratch.places.clear();
  for (const PlacedScan& scan : scans)
    scratch.places.emplace_back(scan.map_from_robot, origin_, resolution_);
  scratch.changed.clear();
  scratch.batch.begin(cells_, evidence_);
  try {
    for (std::size_t i = 0; i < scans.size(); ++i) {
      scratch.raster.build(*scans[i].shape, scratch.places[i]);
      if (scratch.batch.add(scratch.raster)) continue;
      scratch.batch.finish(cells_, scratch.changed);
      scratch.batch.add(scratch.raster);
    }
    scratch.batch.finish(cells_, scratch.changed);
  } catch (...) {  // what has been written so far keeps the field that belongs to it
    field_.update(scratch.changed, cells_);
    throw;
  }
  field_.update(scratch.changed, cells_);
}

}  // namespace ariadne::grid
