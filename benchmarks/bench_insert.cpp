// Scans into maps: once round a corridor of 100 m, scan by scan and all at once, and single scans
// of an open place into the maps of many particles. Ratios between lines of one run count.
#include <benchmark/benchmark.h>

#include "ariadne/grid/map/occupancy_grid.h"
#include "corridor.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

double headingOf(const benchmark::State& state) {
  return static_cast<double>(state.range(0)) * M_PI / 180;
}

/// What a laser reads in the open: a bush or a post here and there, else nothing before 25 m.
mrpt::obs::CObservation2DRangeScan openScan(std::uint64_t seed) {
  core::RandomStream rng(seed, 0, 0, core::Purpose::test);
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(M_PI);
  scan.rightToLeft = true;
  scan.maxRange = 80;
  scan.resizeScan(181);
  double range = 15;
  for (std::size_t i = 0; i < 181; ++i) {
    if (rng.uniform() < 0.3) range = 5 + 20 * rng.uniform();
    scan.setScanRange(i, static_cast<float>(range + 0.02 * rng.gaussian()));
    scan.setScanRangeValidity(i, true);
  }
  return scan;
}

}  // namespace

static void BM_DriveScanByScan(benchmark::State& state) {
  const auto drive = test::corridorLoop({}, headingOf(state));
  for (auto _ : state) {
    grid::OccupancyGrid map;
    for (std::size_t i = 0; i < drive.poses.size(); ++i)
      map.insert(drive.shapes[i], drive.poses[i]);
    benchmark::DoNotOptimize(map);
  }
}
BENCHMARK(BM_DriveScanByScan)->ArgName("deg")->Arg(0)->Arg(30)->Unit(benchmark::kMillisecond);

static void BM_DriveAtOnce(benchmark::State& state) {
  const auto drive = test::corridorLoop({}, headingOf(state));
  const auto scans = drive.placed();
  for (auto _ : state) {
    grid::OccupancyGrid map;
    map.insertMany(scans);
    benchmark::DoNotOptimize(map);
  }
}
BENCHMARK(BM_DriveAtOnce)->ArgName("deg")->Arg(0)->Arg(30)->Unit(benchmark::kMillisecond);

/// Thirty particles with maps of their own, which share tiles with a parent from time to time.
static void BM_InsertOpen(benchmark::State& state) {
  std::vector<grid::ScanShape> shapes;
  for (std::uint64_t i = 0; i < 40; ++i) shapes.push_back(grid::makeScanShape(openScan(i), {}));
  std::vector<grid::OccupancyGrid> maps(static_cast<std::size_t>(state.range(0)));
  std::size_t step = 0;
  for (auto _ : state) {
    if (step % shapes.size() == 0) maps.assign(maps.size(), grid::OccupancyGrid());
    if (step % 10 == 5)  // a resampling
      for (std::size_t i = 0; i < maps.size(); i += 2) maps[i] = maps[(i + 7) % maps.size()];
    const double s = 0.3 * static_cast<double>(step % shapes.size());
    for (std::size_t i = 0; i < maps.size(); ++i)
      maps[i].insert(shapes[step % shapes.size()],
                     {s + 0.01 * static_cast<double>(i), 0.02 * static_cast<double>(i), 0.05 * s});
    ++step;
  }
}
BENCHMARK(BM_InsertOpen)->ArgName("maps")->Arg(1)->Arg(30)->Unit(benchmark::kMicrosecond);
