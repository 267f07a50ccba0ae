#include "explore_app.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/io/output_folder.h"
#include "explore_outputs.h"
#include "loop_counts.h"
#include "loops_json.h"
#include "run_program.h"

namespace ariadne {
namespace {

using namespace explore_app;

constexpr const char* kName = "ariadne-explore";

constexpr const char* kParametersHead = R"(# Parameters of ariadne-explore

Made by `scripts/renew-parameters`; a test compares it with the program.

A value comes from the defaults below, then the INI, then `--set section.key=value` (in order), then
the dedicated options (`--world`, `--start`, `--strategy`, `--particles`, `--seed`, `--threads`, `--out`,
`--no-pictures`). The result is written beside the maps as config.ini. INIs are read as those of
ariadne-slam ([parameters.md](parameters.md)). [explore] strategy sets [loop_closing] stop and
[recovery] enabled, whatever they say.
)";

std::string toldOf(const ExplorationResult& r) {
  if (r.loops == eval::Verdict::no_loop) return "no true loop to judge it by";
  if (r.verdict == "bent") return "bent: every true loop is closed right, but walls are off";
  if (r.loops == eval::Verdict::correct) return "every true loop is closed right";
  return fmt::format("wrong: a loop is off by {:.2f} m, {:.0f} degrees",
                     r.loop_errors.worst_translation.translation_m,
                     r.loop_errors.worst_heading.heading_deg);
}

void printResult(std::ostream& out, const ExplorationResult& r) {
  fmt::print(out, "{}: {:.0f} m in {:.0f} s of driving, computed in {:.1f} s\n",
             r.mission.end_reason, r.mission.distance_m, r.mission.steps.back().time_s,
             r.mapping.record.total_s);
  fmt::print(out, "{:.1f} % of what can be seen was seen; ATE {:.2f} m; map score {:.3f}; {}\n",
             100 * r.coverage, r.mapping.truth->ate_rmse_m, r.score.f1, toldOf(r));
  const slam_app::LoopCounts loops = slam_app::countLoops(r.mapping.closings);
  fmt::print(out, "Loops: {} detected, {} closed, {} followed by a recovery of diversity\n",
             loops.detected, loops.closed, loops.recovered);
}

void tellCollisions(ExplorationResult& result) {
  for (const auto& c : result.mission.collisions)
    result.mapping.warnings.push_back(
        fmt::format("collision at {:.1f} s, truly at ({:.2f}, {:.2f}): the robot was held",
                    c.time_s, c.world_from_robot.x, c.world_from_robot.y));
}

void checkWorld(const WorldParams& world) {
  const bool drawn = world.random != sim::RandomWorld::none;
  if (world.file.empty() && !drawn)
    throw core::UsageError("no world: name one with --world, or in the INI as [world] file");
  if (!world.file.empty() && drawn)
    throw core::UsageError(fmt::format(
        "[world] random and [world] file = {}: one of them names the world; --random, or "
        "--set world.file= leaves the file out",
        world.file));
}

int exploreWorld(const Options& options, ResolvedConfig resolved, std::ostream& out,
                 std::ostream& err) {
  ExploreConfig& config = resolved.config;
  checkWorld(config.world);
  config.run.out = std::filesystem::absolute(outputFolderOf(config)).lexically_normal().string();
  io::writeIni(config, "");  // throws now, not after the drive, for a name that no INI can hold
  const sim::World world = readWorldOf(config);
  resolved.warnings.insert(resolved.warnings.end(), world.notes.begin(), world.notes.end());
  app::warn(err, kName, resolved.warnings);
  const mrpt::math::TPose2D start = startOf(config, world);
  mission::Mission mission(world, start, config.mission, config.run.threads);
  ExplorationResult result;
  const std::vector<slam_app::Output> outputs = outputsOf(config, result);
  io::prepareOutputFolder(config.run.out, slam_app::namesOf(outputs), options.overwrite);

  const app::Interrupt interrupt;
  app::Progress progress(err, app::progressStyle(options.quiet, err));
  report::ReplayRecorder recorder;
  result = carryOut(mission, config, interrupt, progress, recorder);
  if (interrupt.signal() != 0)
    fmt::print(err, "{}: stopped after {:.0f} m; writing what there is\n", kName,
               result.mission.distance_m);
  result.mapping.config.dataset.file = config.run.out + "/drive.rawlog";
  result.mapping.warnings = resolved.warnings;
  // Without recovery there is none to miss: that is the strategy's word, not the user's mistake.
  if (config.mission.slam.recovery.enabled)
    for (const auto& w : slam_app::loopWarnings(result.mapping.closings))
      result.mapping.warnings.push_back(w);
  tellCollisions(result);
  const auto& all = result.mapping.warnings;
  app::warn(err, kName,
            {all.begin() + static_cast<std::ptrdiff_t>(resolved.warnings.size()), all.end()});
  measure(result, mission, world, start);
  if (config.run.pictures) result.mapping.replay = replayOf(recorder, mission.mapper(), result);

  std::ostream nowhere(nullptr);
  std::ostream& told = options.quiet ? nowhere : out;
  printResult(told, result);
  const auto summary = [&](double writing_s, const std::vector<std::string>& files) {
    return summaryText(result, writing_s, files);
  };
  slam_app::writeOutputs(config.run.out, outputs, mission.mapper(), result.mapping, summary, told);
  return interrupt.signal() == 0 ? 0 : 128 + interrupt.signal();
}

int run(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  const auto options = parseOptions(args, out);
  if (!options) return 0;
  if (options->print_parameters) {
    out << io::writeMarkdown(ExploreConfig(), kParametersHead);
    return 0;
  }
  ResolvedConfig resolved = resolveConfig(*options);
  if (!options->print_config) return exploreWorld(*options, std::move(resolved), out, err);
  app::warn(err, kName, resolved.warnings);
  out << io::writeIni(resolved.config, "Configuration of ariadne-explore.");
  return 0;
}

}  // namespace

int runExploreApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  return app::runProgram(kName, err, [&] { return run(args, out, err); });
}

}  // namespace ariadne
