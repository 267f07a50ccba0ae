#include "slam_app.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <chrono>
#include <filesystem>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/io/output_folder.h"
#include "ariadne/io/tum.h"
#include "config.h"
#include "continuation.h"
#include "loop_counts.h"
#include "loops_json.h"
#include "mapping.h"
#include "options.h"
#include "outputs.h"
#include "parameters_page.h"
#include "replay.h"
#include "run_checks.h"
#include "run_program.h"
#include "truth.h"

namespace ariadne {
namespace {

using namespace slam_app;

constexpr const char* kName = "ariadne-slam";

void printResult(std::ostream& out, const RunResult& result) {
  const MappingRecord& record = result.record;
  fmt::print(out, "{} scans over {:.0f} m, {} filter updates, in {:.2f} s\n",
             record.odometry.size(), geometry::lengthOf(result.path), record.reports.size(),
             record.total_s);
  if (!result.config.slam.loop_closing.enabled) return;
  const LoopCounts loops = countLoops(result.closings);
  fmt::print(out, "Loops: {} detected, {} closed, {} followed by a recovery of diversity\n",
             loops.detected, loops.closed, loops.recovered);
  if (!result.found.empty())
    fmt::print(out, "Closures found from metres away: {}\n", result.found.size());
}

/// Lays the truth over the path of the result; a warning when it is of another time.
void compare(RunResult& result, geometry::Trajectory truth, const std::string& file) {
  if (truth.empty()) return;
  result.truth = fitTruth(result.path, std::move(truth));
  if (!result.truth)
    result.warnings.push_back(
        fmt::format("{} has no pose at any time of the log: nothing is compared with it", file));
}

/// All that mapping came to but truth and replay.
RunResult resultOf(MappingRecord record, const slam::Mapper& mapper, const io::StepSource& source,
                   const ResolvedConfig& resolved) {
  RunResult result;
  result.record = std::move(record);
  result.config = resolved.config;
  result.stages = mapper.times();
  result.path = mapper.path();
  result.closings = mapper.closings();
  result.doubts = mapper.doubts();
  result.found = mapper.foundClosures();
  result.learned = mapper.learnedMotion();
  result.counts = source.counts();
  result.laser_label = source.laserLabel();
  result.warnings = resolved.warnings;
  for (const std::string& w : source.warnings()) result.warnings.push_back(w);
  return result;
}

std::vector<Output> outputsOf(const SlamConfig& config) {
  std::vector<Output> outputs = mappingOutputs(config);
  outputs.push_back(mappingIni("config.ini"));
  return outputs;
}

/// Recordings of ROS are looked through first, which is told where it takes its time.
std::unique_ptr<io::StepSource> openLog(const DatasetParams& params,
                                        const app::Interrupt& interrupt, bool quiet,
                                        std::ostream& err) {
  app::Progress progress(err, app::progressStyle(quiet, err));
  io::DatasetOptions options = optionsOf(params);
  options.goes_on = [&](double share) {
    progress.tell("looking through it", share);
    return interrupt.signal() == 0;
  };
  auto source = io::openDataset(params.file, options);
  progress.finish();
  return source;
}

/// Of [continue]; nothing known where that is empty.
Continuation whereFrom(const SlamConfig& config, const app::Interrupt& interrupt, bool quiet,
                       std::ostream& err) {
  if (config.continue_from.run.empty()) return {};
  if (!quiet)
    fmt::print(err, "{}: looking for the log's start in {}\n", kName, config.continue_from.run);
  Continuation from = continuationOf(config, *openLog(config.dataset, interrupt, quiet, err));
  if (!quiet) fmt::print(err, "{}: {}\n", kName, from.note);
  return from;
}

/// Maps and writes. Returns the exit code.
int mapDataset(const Options& options, ResolvedConfig resolved, std::ostream& out,
               std::ostream& err) {
  SlamConfig& config = resolved.config;
  if (config.dataset.file.empty())
    throw core::UsageError("no dataset: name one behind CONFIG, or in the INI as [dataset] file");
  config.run.out = std::filesystem::absolute(outputFolderOf(config)).lexically_normal().string();
  io::writeIni(config, "");  // throws now, not after mapping, for a name that no INI can hold
  app::warn(err, kName, resolved.warnings);
  if (std::error_code ignored; !std::filesystem::exists(config.dataset.file, ignored))
    throw core::Error(fmt::format("there is no log {}; to map another, name it behind CONFIG",
                                  config.dataset.file));
  geometry::Trajectory truth;
  if (!options.truth.empty()) truth = io::readTum(options.truth);

  const app::Interrupt interrupt;
  const auto opening = std::chrono::steady_clock::now();
  Continuation from = whereFrom(config, interrupt, options.quiet, err);
  const auto source = openLog(config.dataset, interrupt, options.quiet, err);
  const std::chrono::duration<double> opened = std::chrono::steady_clock::now() - opening;
  slam::Mapper mapper(config.slam, config.run.threads, from.known, from.start);
  from.known.clear();
  const std::vector<Output> outputs = outputsOf(config);
  io::prepareOutputFolder(config.run.out, namesOf(outputs), options.overwrite);
  app::Progress progress(err, app::progressStyle(options.quiet, err));
  report::ReplayRecorder recorder;
  MappingRecord record =
      mapSteps(*source, mapper, config, interrupt, progress, recordingOf(config, mapper, recorder));
  record.reading_s += opened.count();
  record.total_s += opened.count();
  if (mapper.updates() == 0) throw nothingMapped(config, record, mapper);
  app::warn(err, kName, source->warnings());
  if (record.signal != 0)
    fmt::print(err, "ariadne-slam: stopped after {} scans ({:.0f} % of the log); writing these\n",
               record.odometry.size(), 100 * source->fraction());
  RunResult result = resultOf(std::move(record), mapper, *source, resolved);
  const std::size_t told_already = result.warnings.size();
  checkRun(result);
  for (const std::string& w : loopWarnings(result.closings)) result.warnings.push_back(w);
  compare(result, std::move(truth), options.truth);
  result.from = std::move(from);
  app::warn(
      err, kName,
      {result.warnings.begin() + static_cast<std::ptrdiff_t>(told_already), result.warnings.end()});
  if (config.run.pictures) result.replay = replayOf(recorder, mapper, result);

  std::ostream nowhere(nullptr);
  std::ostream& told = options.quiet ? nowhere : out;
  printResult(told, result);
  const auto summary = [&](double writing_s, const std::vector<std::string>& files) {
    return jsonText(summaryOf(result, writing_s, files));
  };
  writeOutputs(config.run.out, outputs, mapper, result, summary, told);
  return result.record.signal == 0 ? 0 : 128 + result.record.signal;
}

int run(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  const auto options = parseOptions(args, out);
  if (!options) return 0;
  if (options->print_parameters) {
    out << parametersPage();
    return 0;
  }
  ResolvedConfig resolved = resolveConfig(*options);
  if (!options->print_config) return mapDataset(*options, std::move(resolved), out, err);
  app::warn(err, kName, resolved.warnings);
  out << io::writeIni(resolved.config, "Configuration of ariadne-slam.");
  return 0;
}

}  // namespace

int runSlamApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  return app::runProgram(kName, err, [&] { return run(args, out, err); });
}

}  // namespace ariadne
