// Loops: recovery of 30 particles across a loop of 100 m next to a rebuild from scratch, and the
// detection with 100 particles and 500 places. One thread.
#include <benchmark/benchmark.h>

#include "ariadne/geometry/pose.h"
#include "ariadne/loops/places/loop_opportunity.h"
#include "ariadne/loops/recovery/recover.h"
#include "corridor.h"
#include "corridors.h"

using namespace ariadne;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

namespace {

/// Thirty particles that stood at different poses at te = 0 and went the same loop.
struct Loop {
  Loop()
      : drive(test::corridorLoop()),
        parallel(1),
        set(models(), parallel, {}, grid::OccupancyGrid()) {
    grid::OccupancyGrid map;
    map.insertMany(drive.placed());
    loops::PlaceGraph graph;
    for (const auto& p : drive.poses) graph.extend({p.x, p.y}, map, {});
    std::vector<filter::Particle> particles;
    for (std::size_t i = 0; i < 30; ++i) {
      const TPose2D start(0.01 * static_cast<double>(i), 0.007 * static_cast<double>(i),
                          0.001 * static_cast<double>(i));
      filter::Particle p;
      for (std::size_t k = 0; k < drive.poses.size(); ++k) {
        p.ancestor = std::make_shared<filter::Ancestor>(
            p.ancestor, k, geometry::compose(start, drive.poses[k]), 0.0);
        if (k > 0) continue;
        p.map.insert(drive.shapes[0], start);
        p.checkpoints = std::make_shared<filter::Checkpoint>(0U, p.map, nullptr);
        saved.entries.push_back({p.ancestor, nullptr, p.checkpoints, 1 / 30.0, graph.asOf(0)});
      }
      p.map_from_robot = p.ancestor->pose();
      particles.push_back(p);
    }
    saved.saving = drive.poses.size() - 1;
    set.replace(particles, std::vector<double>(30, 1 / 30.0));
    graphs.assign(30, graph);
  }
  static filter::FilterModels models() {
    filter::FilterModels m;
    m.filter.particles = 30;
    return m;
  }
  test::Drive drive;
  core::Parallel parallel;
  filter::ParticleSet set;
  loops::SavedSet saved;
  std::vector<loops::PlaceGraph> graphs;
};

/// A robot that mowed a hall of 66 x 86 m: 500 places, neighbouring lanes far apart by the graph.
struct Hall {
  Hall() {
    test::drawRoom(map, -3, -3, 63, 83);
    while (graph.places().size() < 500) {
      graph.extend(at, map, {});
      travel();
    }
  }
  void travel() {
    const bool right = static_cast<int>(at.y / 4) % 2 == 0;
    if ((right && at.x < 60) || (!right && at.x > 0))
      at.x += right ? 0.3 : -0.3;
    else
      at.y += 4;
  }
  grid::OccupancyGrid map;
  loops::PlaceGraph graph;
  TPoint2D at{0, 0};
};

}  // namespace

static void BM_Recovery(benchmark::State& state) {
  const Loop loop;
  for (auto _ : state) {
    auto out = loops::recover(loop.saved, loop.set, loop.graphs,
                              {loop.drive.shapes, 100, 1, loop.parallel}, loops::Draw::independent);
    benchmark::DoNotOptimize(out);
  }
}
BENCHMARK(BM_Recovery)->Unit(benchmark::kMillisecond);

static void BM_RebuildFromScratch(benchmark::State& state) {
  const Loop loop;
  for (auto _ : state)
    for (std::size_t i = 0; i < 30; ++i) {
      grid::OccupancyGrid map;
      const TPose2D start = loop.saved.entries[i].at_te->pose();
      for (std::size_t k = 0; k < loop.drive.poses.size(); ++k)
        map.insert(loop.drive.shapes[k], geometry::compose(start, loop.drive.poses[k]));
      benchmark::DoNotOptimize(map);
    }
}
BENCHMARK(BM_RebuildFromScratch)->Unit(benchmark::kMillisecond);

static void BM_ExtendGraphs(benchmark::State& state) {
  Hall hall;
  std::vector<loops::PlaceGraph> graphs(100, hall.graph);
  for (auto _ : state) {
    for (auto& g : graphs) g.extend(hall.at, hall.map, {});
    hall.at.x += hall.at.x > 30 ? -0.3 : 0.3;
  }
}
BENCHMARK(BM_ExtendGraphs)->Unit(benchmark::kMicrosecond);

/// `open` 1: an opportunity exists, and the map is searched; 0: the graph alone says there is none.
static void BM_FindOpportunity(benchmark::State& state) {
  const Hall hall;
  loops::OpportunityParams params;
  if (state.range(0) == 0) params.c2_m = 1e5;
  for (auto _ : state) {
    auto found = loops::findOpportunity(hall.graph, hall.map, hall.at, params,
                                        [](const auto&) { return true; });
    benchmark::DoNotOptimize(found);
  }
}
BENCHMARK(BM_FindOpportunity)->ArgName("open")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);
