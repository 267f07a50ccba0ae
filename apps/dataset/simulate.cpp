#include "simulate.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "ariadne/geometry/trajectory.h"
#include "ariadne/io/dataset_writers.h"
#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/report/overview.h"
#include "ariadne/sim/drive.h"
#include "overwrite.h"
#include "progress.h"

namespace ariadne {
namespace {

namespace fs = std::filesystem;

sim::SimParams paramsOf(const SimulateArguments& args) {
  sim::SimParams params;
  for (const std::string& setting : args.settings) io::setField(params, io::parseSetting(setting));
  return params;
}

sim::DrivePath pathOf(const SimulateArguments& args) {
  sim::DrivePath path = sim::readPath(args.path, args.laps);
  if (args.laps && !path.has_laps_block)
    throw core::UsageError(
        fmt::format("{} has no block `repeat laps`: leave --laps out", args.path.string()));
  return path;
}

sim::TruthDrive drive(const SimulateArguments& args, const sim::World& world,
                      const sim::DriveParams& params, std::ostream& err) {
  const sim::DrivePath path = pathOf(args);
  const std::string what = "driving " + args.path.filename().string();
  app::Progress progress(err, app::progressStyle(false, err));
  return sim::driveThrough(world, path, params, [&](double done) { progress.tell(what, done); });
}

std::string summaryOf(const geometry::Trajectory& poses) {
  return fmt::format("{} scans, {:.1f} m, {:.1f} s", poses.size(), geometry::lengthOf(poses),
                     poses.back().time_s);
}

sim::World worldOf(const SimulateArguments& args, std::ostream& err) {
  sim::World world = sim::readWorld(args.world);
  for (const std::string& note : world.notes) err << "ariadne-dataset: " << note << '\n';
  return world;
}

/// Size and floor, and where a robot starts.
std::string summaryOf(const sim::World& world) {
  const auto& map = world.map;
  std::size_t floor = 0;
  for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x) floor += map.getCell(x, y) > 0.5F;
  const double cell = map.getResolution();
  return fmt::format("{:.1f} x {:.1f} m in cells of {:.3g} m, {:.1f} m2 of floor; {}",
                     map.getXMax() - map.getXMin(), map.getYMax() - map.getYMin(), cell,
                     static_cast<double>(floor) * cell * cell,
                     world.start
                         ? fmt::format("start at {:.2f}, {:.2f}, {:.0f} degrees", world.start->x,
                                       world.start->y, world.start->phi * 180 / M_PI)
                         : "it names no start");
}

fs::path beside(fs::path path, const char* ending) { return path += ending; }

std::vector<std::string> recipe(const SimulateArguments& args) {
  std::string command =
      fmt::format("ariadne-dataset simulate {} {} {} --seed {}", args.world.filename().string(),
                  args.path.filename().string(), args.out.filename().string(), args.seed);
  if (args.laps) command += fmt::format(" --laps {}", *args.laps);
  for (const std::string& setting : args.settings) command += " --set " + setting;
  return {"true poses of the simulated robot at each scan, in the frame of the world", command};
}

}  // namespace

void simulate(const SimulateArguments& args, std::ostream& out, std::ostream& err) {
  const fs::path truth_file = beside(args.out, ".truth.tum");
  const fs::path marks_file = beside(args.out, ".marks.csv");
  for (const fs::path& file : {args.out, truth_file, marks_file})
    refuseToOverwrite(file, args.overwrite);
  const sim::SimParams params = paramsOf(args);
  const sim::World world = worldOf(args, err);
  const auto seen = sim::observe(drive(args, world, params.drive, err), params.noise, args.seed);

  std::size_t next = 0;
  io::writeRawlog(args.out, [&] {
    return next < seen.steps.size() ? std::optional(seen.steps[next++]) : std::nullopt;
  });
  io::writeTum(truth_file, seen.truth, recipe(args));
  std::string marks = "name,time_s\n";
  for (const sim::MarkTime& mark : seen.marks)
    marks += fmt::format("{},{:.3f}\n", mark.name, mark.time_s);
  io::writeWhole(marks_file, marks);
  out << fmt::format("{}; wrote {}, {}, {}\n", summaryOf(seen.truth), args.out.string(),
                     truth_file.string(), marks_file.string());
}

void drawWorld(const SimulateArguments& args, std::ostream& out, std::ostream& err) {
  if (args.random) {
    refuseToOverwrite(args.world, args.overwrite);
    io::writeWhole(args.world, sim::randomWorld(*args.random, args.seed));
    out << fmt::format("wrote {}\n", args.world.string());
    if (args.out.empty()) return;
  }
  if (args.out.empty()) throw core::UsageError("OUT is missing: the PNG to write");
  refuseToOverwrite(args.out, args.overwrite);
  const sim::World world = worldOf(args, err);
  geometry::Trajectory poses;
  if (world.start) poses = {{0, *world.start}};
  if (args.path.empty() && (args.laps || !args.settings.empty()))
    throw core::UsageError("--laps and --set are for a drive: --path names it");
  std::string summary = summaryOf(world);
  if (!args.path.empty()) {
    poses = drive(args, world, paramsOf(args).drive, err).poses;
    summary += "; driven: " + summaryOf(poses);
  }
  report::writeOverview(args.out, world.map, poses);
  out << fmt::format("{}; wrote {}\n", summary, args.out.string());
}

std::string simulationKeys() {
  std::string text;
  io::forEachWrittenSection(
      sim::SimParams{}, [&](const char* section, const std::vector<io::WrittenField>& fields) {
        for (const io::WrittenField& f : fields)
          text += fmt::format("  {}.{}={}  {} ({})\n", section, f.key, f.value, f.help, f.takes);
      });
  return text;
}

}  // namespace ariadne
