// MRPT's rbpf-slam without windows, pictures and logs: the same loop over the same
// CMetricMapBuilderRBPF, so that its cost can be measured where the package mrpt-apps and its
// wxWidgets are not installed.
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/random.h>

#include <iostream>
#include <optional>

#include "ariadne/io/whole_file.h"
#include "command_line.h"
#include "run_program.h"
#include "stock_mapping.h"
#include "stock_outputs.h"

namespace {

using namespace mrpt;
constexpr const char* kName = "ariadne-stock-rbpf";
constexpr const char* kSection = "MappingApplication";

struct Options {
  std::string config;
  std::string rawlog;
  ariadne::stock_app::OutputFiles files;
  std::optional<int> particles;
  std::optional<int> algorithm;
  int seed = -1;
};

void declare(CLI::App& app, Options& o) {
  app.add_option("CONFIG", o.config, "INI of rbpf-slam")->required();
  app.add_option("RAWLOG", o.rawlog, "rawlog of actions and frames")->required();
  app.add_option("--trajectory", o.files.trajectory, "TUM file: mean pose at every scan");
  app.add_option("--path", o.files.path, "TUM file: path of the best particle in the end");
  app.add_option("--overview", o.files.overview, "PNG file: that path on its map");
  app.add_option("--summary", o.files.summary, "JSON file: updates, Neff, costs");
  app.add_option("--particles", o.particles, "instead of sampleSize");
  app.add_option("--pf-algorithm", o.algorithm, "instead of PF_algorithm");
  app.add_option("--seed", o.seed, "instead of RANDOM_SEED; negative: by the clock");
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

int run(const std::vector<std::string>& args) {
  CLI::App app("MRPT's CMetricMapBuilderRBPF on a rawlog, headless; for benchmarks.", kName);
  Options o;
  declare(app, o);
  if (!ariadne::app::parseCommandLine(app, args, std::cout)) return 0;
  int seed = -1;
  slam::CMetricMapBuilderRBPF builder(builderOptions(o, seed));
  if (seed >= 0)
    random::getRandomGenerator().randomize(static_cast<std::uint32_t>(seed));
  else
    random::getRandomGenerator().randomize();
  const auto run = ariadne::stock_app::mapRawlog(o.rawlog, builder);
  ariadne::stock_app::printCosts(run, builder);
  ariadne::stock_app::writeOutputs(o.files, run, builder);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return ariadne::app::runProgram(kName, std::cerr, [&] { return run({argv + 1, argv + argc}); });
}
