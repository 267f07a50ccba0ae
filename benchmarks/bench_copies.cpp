// What a resampling costs, whatever the map's size.
#include <benchmark/benchmark.h>

#include <numeric>

#include "ariadne/filter/particle_set.h"

using namespace ariadne;

namespace {

/// A square map of so many MB at a byte a cell (as MRPT keeps it; packed it is less), no two tiles
/// alike.
grid::OccupancyGrid mapOf(std::int64_t megabytes) {
  grid::OccupancyGrid map;
  const int side = static_cast<int>(std::sqrt(static_cast<double>(megabytes << 20)));
  for (int y = 0; y < side; y += 8)
    for (int x = 0; x < side; x += 8) map.set({x, y}, static_cast<std::int8_t>(1 + (x ^ y) % 100));
  return map;
}

}  // namespace

static void BM_CopyMap(benchmark::State& state) {
  const auto map = mapOf(state.range(0));
  for (auto _ : state) {
    grid::OccupancyGrid copy = map;
    benchmark::DoNotOptimize(copy);
  }
}
BENCHMARK(BM_CopyMap)->ArgName("MB")->Arg(10)->Arg(40)->Arg(160);

/// Time a particle: half of them survive, each with two children.
static void BM_Resample(benchmark::State& state) {
  filter::FilterModels models;
  models.filter.particles = 100;
  const core::Parallel parallel(1);
  filter::ParticleSet set(models, parallel, {}, mapOf(state.range(0)));
  std::vector<std::size_t> indices(100);
  for (std::size_t i = 0; i < 100; ++i) indices[i] = i / 2 * 2;
  for (auto _ : state) set.performSubstitution(indices);
  state.counters["s_per_particle"] = benchmark::Counter(
      100, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_Resample)->ArgName("MB")->Arg(10)->Arg(40)->Arg(160)->Unit(benchmark::kMicrosecond);

/// The first cell written after a copy: table, block and tile are copied then.
static void BM_FirstWriteAfterCopy(benchmark::State& state) {
  const auto map = mapOf(state.range(0));
  for (auto _ : state) {
    grid::OccupancyGrid copy = map;
    copy.set({100, 100}, -5);
    benchmark::DoNotOptimize(copy);
  }
}
BENCHMARK(BM_FirstWriteAfterCopy)->ArgName("MB")->Arg(10)->Arg(40)->Arg(160);
