// MRPT's rbpf-slam without windows, pictures and logs: the same loop over the same
// CMetricMapBuilderRBPF (mrpt/libs/apps/src/RBPF_SLAM_App.cpp, 2.5.8), so that its cost can be
// measured where the package mrpt-apps and its wxWidgets are not installed.
#include <fmt/format.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/random.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/slam/CMetricMapBuilderRBPF.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "ariadne/core/error.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"

namespace {

using namespace mrpt;
constexpr const char* kSection = "MappingApplication";

struct Options {
  std::string config;
  std::string rawlog;
  std::string trajectory;
  std::optional<int> particles;
  std::optional<int> algorithm;
  int seed = -1;
};

Options parse(CLI::App& app, int argc, char** argv) {
  Options o;
  app.add_option("CONFIG", o.config, "INI of rbpf-slam")->required();
  app.add_option("RAWLOG", o.rawlog, "rawlog of actions and frames")->required();
  app.add_option("--trajectory", o.trajectory, "TUM file: mean pose at every scan");
  app.add_option("--particles", o.particles, "instead of sampleSize");
  app.add_option("--pf-algorithm", o.algorithm, "instead of PF_algorithm");
  app.add_option("--seed", o.seed, "instead of RANDOM_SEED; negative: by the clock");
  app.parse(argc, argv);
  return o;
}

slam::CMetricMapBuilderRBPF::TConstructionOptions builderOptions(const Options& o, int& seed) {
  config::CConfigFileMemory ini;
  ini.setContent(ariadne::io::readWhole(o.config));
  if (o.particles) ini.write(kSection, "sampleSize", *o.particles);
  if (o.algorithm) ini.write(kSection, "PF_algorithm", *o.algorithm);
  seed = o.seed >= 0 ? o.seed : ini.read_int(kSection, "RANDOM_SEED", -1);
  slam::CMetricMapBuilderRBPF::TConstructionOptions options;
  options.loadFromConfigFile(ini, kSection);
  options.verbosity_level = system::LVL_ERROR;
  return options;
}

/// The stock app's estimate at every scan: the particles' mean.
math::TPose2D meanPose(const slam::CMetricMapBuilderRBPF& builder) {
  poses::CPose3D mean;
  builder.getCurrentPoseEstimation()->getMean(mean);
  return {mean.x(), mean.y(), mean.yaw()};
}

ariadne::models::Trajectory map(const Options& o, slam::CMetricMapBuilderRBPF& builder) {
  io::CFileGZInputStream file;
  std::string problem;
  if (!file.open(o.rawlog, problem))
    throw ariadne::core::Error(fmt::format("cannot read {}: {}", o.rawlog, problem));
  auto archive = serialization::archiveFrom(file);
  ariadne::models::Trajectory trajectory;
  std::size_t entry = 0;
  obs::CActionCollection::Ptr action;
  obs::CSensoryFrame::Ptr frame;
  obs::CObservation::Ptr observation;
  while (obs::CRawlog::getActionObservationPairOrObservation(archive, action, frame, observation,
                                                             entry)) {
    if (!action || !frame || frame->empty())
      throw ariadne::core::Error(o.rawlog + ": rbpf-slam takes rawlogs of actions and frames only");
    builder.processActionObservation(*action, *frame);
    trajectory.push_back({Clock::toDouble((*frame->begin())->timestamp), meanPose(builder)});
  }
  return trajectory;
}

void printCosts(std::size_t scans, unsigned updates) {
  rusage u{};
  getrusage(RUSAGE_SELF, &u);
  const double cpu_s = static_cast<double>(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
                       1e-6 * static_cast<double>(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
  std::printf("scans %zu, frames in the map %u, CPU user+system %.2f s, peak memory %.0f MB\n",
              scans, updates, cpu_s, static_cast<double>(u.ru_maxrss) / 1024);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("MRPT's CMetricMapBuilderRBPF on a rawlog, headless; for benchmarks.");
  try {
    const Options o = parse(app, argc, argv);
    int seed = -1;
    slam::CMetricMapBuilderRBPF builder(builderOptions(o, seed));
    if (seed >= 0)
      random::getRandomGenerator().randomize(static_cast<std::uint32_t>(seed));
    else
      random::getRandomGenerator().randomize();
    const auto trajectory = map(o, builder);
    if (!o.trajectory.empty())
      ariadne::io::writeTum(o.trajectory, trajectory,
                            {"map_from_robot, mean of the particles at every scan, stock MRPT"});
    printCosts(trajectory.size(), builder.getCurrentlyBuiltMapSize());
    return 0;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "ariadne-stock-rbpf: %s\n", e.what());
    return 1;
  }
}
