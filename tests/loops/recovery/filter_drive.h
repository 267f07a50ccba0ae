// A filter on laps in the room of room.h, with the graph of places of each particle: what recovery
// works on.
#pragma once
#include <vector>

#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/loops/places/place_graph.h"
#include "ariadne/loops/recovery/recover.h"
#include "room.h"

namespace ariadne::test {

struct FilterDrive {
  explicit FilterDrive(int particles, mrpt::math::TPose2D start = {}, int threads = 1)
      : models(modelsFor(particles)),
        parallel(threads),
        set(models, parallel, start, grid::OccupancyGrid(models.grid)),
        graphs(set.size()) {}
  static filter::FilterModels modelsFor(int particles) {
    filter::FilterModels m;
    m.filter.particles = particles;
    m.filter.weight_gain = 0.02;   // some hypotheses must be left to save
    m.grid.resolution_m = 0.0625;  // moves by whole cells are exact
    return m;
  }

  void steps(int n) {
    for (int i = 0; i < n; ++i) step();
  }
  void step() {
    const mrpt::math::TPose2D increment(0.25, 0, 0.25);
    truth = geometry::compose(truth, increment);
    const grid::Scan scan = grid::takeScan(scanIn(world, truth), models.grid,
                                           static_cast<std::size_t>(models.matcher.max_beams));
    set.predict({0.26, 0.01, 0.24});
    set.match(scan);
    set.weigh(scan);
    if (set.neff() < models.filter.beta * static_cast<double>(set.size())) set.resample();
    set.insert(scan, 5);
    shapes.push_back(scan.shape);
    std::vector<loops::PlaceGraph> next;
    for (std::size_t i = 0; i < set.size(); ++i) {
      next.push_back(graphs[set.parents()[i]]);
      const auto& pose = set[i].map_from_robot;
      next.back().extend({pose.x, pose.y}, set[i].map, places);
    }
    graphs = std::move(next);
  }
  loops::SavedSet save(std::size_t te) const { return loops::save(set, graphs, te); }
  loops::RecoveredSet recover(const loops::SavedSet& saved,
                              loops::Draw draw = loops::Draw::independent) const {
    return loops::recover(saved, set, graphs, {shapes, 5, models.filter.seed, parallel}, draw);
  }

  filter::FilterModels models;
  core::Parallel parallel;
  filter::ParticleSet set;
  std::vector<loops::PlaceGraph> graphs;
  std::vector<grid::ScanShape> shapes;
  loops::PlaceParams places{0.5, 2, 0.3};
  mrpt::maps::COccupancyGridMap2D world = roomWorld();
  mrpt::math::TPose2D truth{-1, -0.8, 0};
};

/// Cells of the two maps that differ, b moved by (dx, dy) cells.
inline std::size_t differingCells(const grid::OccupancyGrid& a, const grid::OccupancyGrid& b,
                                  int dx = 0, int dy = 0) {
  const auto box = a.knownBox();
  std::size_t differing = 0;
  for (int y = box.y0 - 40; y < box.y1 + 40; ++y)
    for (int x = box.x0 - 40; x < box.x1 + 40; ++x)
      differing += a.at({x, y}) != b.at({x + dx, y + dy}) ||
                   a.fieldAt({x, y}) != b.fieldAt({x + dx, y + dy});
  return differing;
}

}  // namespace ariadne::test
