#include "stock_outputs.h"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/system/os.h>
#include <sys/resource.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "ariadne/core/error.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/report/overview.h"

namespace ariadne::stock_app {
namespace {

struct Costs {
  double cpu_s = 0;
  double peak_memory_mb = 0;
};

Costs costsUntilNow() {
  rusage u{};
  getrusage(RUSAGE_SELF, &u);
  return {static_cast<double>(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
              1e-6 * static_cast<double>(u.ru_utime.tv_usec + u.ru_stime.tv_usec),
          static_cast<double>(u.ru_maxrss) / 1024};
}

/// MRPT gives a pointer up to 2.5, a reference later.
[[maybe_unused]] const mrpt::maps::CMultiMetricMap& mapsOf(
    const mrpt::maps::CMultiMetricMap* maps) {
  return *maps;
}
[[maybe_unused]] const mrpt::maps::CMultiMetricMap& mapsOf(
    const mrpt::maps::CMultiMetricMap& maps) {
  return maps;
}

void writeOverview(const std::string& file, const StockRun& run,
                   const mrpt::slam::CMetricMapBuilderRBPF& builder) {
  using Grid = mrpt::maps::COccupancyGridMap2D;
  const auto& maps = mapsOf(builder.getCurrentlyBuiltMetricMap());
  if (maps.countMapsByClass<Grid>() == 0)
    throw core::Error(file + ": the INI asks for no occupancy grid, so there is none to draw");
  report::writeOverview(file, *maps.mapByClass<Grid>(), run.path);
}

}  // namespace

void writeOutputs(const OutputFiles& files, const StockRun& run,
                  mrpt::slam::CMetricMapBuilderRBPF& builder) {
  if (!files.trajectory.empty())
    io::writeTum(files.trajectory, run.mean,
                 {"map_from_robot, mean of the particles at every scan, stock MRPT"});
  if (!files.path.empty())
    io::writeTum(files.path, run.path,
                 {"map_from_robot, path of the best particle in the end, a pose at every scan; "
                  "between filter updates along the odometry; stock MRPT"});
  if (!files.overview.empty()) writeOverview(files.overview, run, builder);
  if (files.summary.empty()) return;
  const Costs costs = costsUntilNow();
  const nlohmann::ordered_json json{
      {"program", "ariadne-stock-rbpf"},
      {"versions", {{"mrpt", mrpt::system::MRPT_getVersion()}}},
      {"dataset", {{"scans", run.path.size()}}},
      {"filter",
       {{"updates", run.updates},
        {"frames_in_map", builder.getCurrentlyBuiltMapSize()},
        {"neff_share_after_mean", run.neff_share_mean},
        {"neff_share_after_min", run.neff_share_min}}},
      {"costs", {{"cpu_s", costs.cpu_s}, {"peak_memory_mb", costs.peak_memory_mb}}}};
  io::writeWhole(files.summary, json.dump(2) + "\n");
}

void printCosts(const StockRun& run, mrpt::slam::CMetricMapBuilderRBPF& builder) {
  const Costs costs = costsUntilNow();
  std::printf("scans %zu, frames in the map %u, CPU user+system %.2f s, peak memory %.0f MB\n",
              run.path.size(), builder.getCurrentlyBuiltMapSize(), costs.cpu_s,
              costs.peak_memory_mb);
}

}  // namespace ariadne::stock_app
