// A room to match scans in: 8 x 5 m, with a niche and a pillar, and what a laser sees of it.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose2D.h>

#include "ariadne/grid/insertion/scan_shape.h"
#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::test {

/// MRPT's grid with walls of 10 cm; free inside.
inline mrpt::maps::COccupancyGridMap2D roomWorld() {
  mrpt::maps::COccupancyGridMap2D world(-6, 6, -4, 4, 0.02f);
  world.fill(0.9f);
  const auto box = [&](double x0, double y0, double x1, double y1) {
    for (double x = x0; x < x1; x += 0.02)
      for (double y = y0; y < y1; y += 0.02) world.setPos(x + 0.01, y + 0.01, 0.0f);
  };
  box(-4.1, -2.6, 4.1, -2.5);
  box(-4.1, 2.5, 4.1, 2.6);
  box(-4.1, -2.6, -4.0, 2.6);
  box(4.0, -2.6, 4.1, 2.6);
  box(1.5, 1.2, 1.9, 1.6);
  box(-2.5, -2.5, -1.2, -1.6);
  return world;
}

/// What a 180-degree laser at the pose reads, by MRPT's simulator.
inline mrpt::obs::CObservation2DRangeScan::Ptr scanIn(const mrpt::maps::COccupancyGridMap2D& world,
                                                      const mrpt::math::TPose2D& pose,
                                                      double noise_m = 0, double aperture = M_PI) {
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->aperture = static_cast<float>(aperture);
  scan->rightToLeft = true;
  scan->maxRange = 20;
  world.laserScanSimulator(*scan, mrpt::poses::CPose2D(pose), 0.5f, 181,
                           static_cast<float>(noise_m));
  return scan;
}

/// A map of the room from scans all around.
inline grid::OccupancyGrid roomMap(const grid::GridParams& params = {}) {
  const auto world = roomWorld();
  grid::OccupancyGrid map(params);
  for (int i = 0; i < 12; ++i) {
    const mrpt::math::TPose2D pose(0.3 * (i % 4), 0.2 * (i % 3), i * M_PI / 6);
    map.insert(grid::makeScanShape(*scanIn(world, pose), params), pose);
  }
  return map;
}

}  // namespace ariadne::test
