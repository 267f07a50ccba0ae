// The parts of a filter update, a particle each, in a room of 8 x 5 m.
#include <benchmark/benchmark.h>

#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/models/proposal.h"
#include "ariadne/models/scan_matcher.h"
#include "room.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

const mrpt::obs::CObservation2DRangeScan& scan() {
  static const auto s = test::scanIn(test::roomWorld(), {0.1, 0.05, 0.3});
  return *s;
}

const grid::OccupancyGrid& map() {
  static const auto m = test::roomMap();
  return m;
}

}  // namespace

static void BM_PrepareScan(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(grid::makeScanShape(scan(), {}));
}
BENCHMARK(BM_PrepareScan);

static void BM_Insert(benchmark::State& state) {
  const auto shape = grid::makeScanShape(scan(), {});
  grid::OccupancyGrid m = map();
  int i = 0;
  for (auto _ : state) {
    if (++i % 20 == 0) m = map();  // else everything is saturated
    m.insert(shape, {0.1 + 0.01 * (i % 20), 0.05, 0.3});
  }
}
BENCHMARK(BM_Insert);

static void BM_Match(benchmark::State& state) {
  const auto points = grid::scanPoints(scan(), 30);
  const models::ScanMatcher matcher({}, 8);
  const Eigen::Matrix3d prior = Eigen::Vector3d(0.01, 0.01, 0.005).asDiagonal();
  for (auto _ : state) benchmark::DoNotOptimize(matcher(map(), points, {0.15, 0.0, 0.34}, prior));
}
BENCHMARK(BM_Match);

static void BM_Likelihood(benchmark::State& state) {
  const auto points = grid::scanPoints(scan(), 30);
  const grid::EndpointLikelihood likelihood({}, grid::GridParams().field_sigma_m);
  for (auto _ : state) benchmark::DoNotOptimize(likelihood(map(), points, {0.1, 0.05, 0.3}));
}
BENCHMARK(BM_Likelihood);

static void BM_Proposal(benchmark::State& state) {
  const auto points = grid::scanPoints(scan(), 30);
  const grid::EndpointLikelihood likelihood({}, grid::GridParams().field_sigma_m);
  const models::PosePrior prior{{0.1, 0.05, 0.3}, Eigen::Vector3d(0.01, 0.01, 0.005).asDiagonal()};
  for (auto _ : state)
    benchmark::DoNotOptimize(
        models::fitProposal(likelihood, map(), points, {0.1, 0.05, 0.3}, prior, {}));
}
BENCHMARK(BM_Proposal);
