#include "outputs.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <chrono>
#include <ostream>

#include "ariadne/charts/gnuplot.h"
#include "ariadne/core/error.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/io/map_files.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/report/overview.h"
#include "ariadne/report/report_page.h"
#include "loop_pictures.h"
#include "loops_json.h"
#include "seconds_since.h"
#include "steps_csv.h"

namespace ariadne::slam_app {
namespace {

namespace fs = std::filesystem;
using Grid = mrpt::maps::COccupancyGridMap2D;

void writeConfig(const fs::path& file, const Material& m) {
  const std::string header =
      fmt::format("As resolved for this run. Maps the same again: ariadne-slam {} --out OTHER",
                  file.filename().string());
  io::writeWhole(file, io::writeIni(m.result.config, header));
}

void writePath(const fs::path& file, const Material& m) {
  io::writeTum(file, m.result.path,
               {"map_from_robot: path of the best particle, a pose at every scan; between filter "
                "updates along the odometry",
                "time_s x_m y_m z_m qx qy qz qw"});
}

void writeOdometry(const fs::path& file, const Material& m) {
  io::writeTum(file, m.result.record.odometry,
               {m.result.config.dataset.odometry == OdometrySource::log
                    ? "odom_from_robot: the odometry as recorded, a pose at every scan"
                    : "odom_from_robot: made by matching scan after scan, a pose at every scan",
                "time_s x_m y_m z_m qx qy qz qw"});
}

const std::vector<Output>& allOutputs() {
  static const std::vector<Output> outputs = {
      {{"trajectory.tum"}, "the robot's path in the map, a pose at every scan", false, writePath},
      {{"odometry.tum"}, "the same by odometry alone", false, writeOdometry},
      {{"steps.csv"},
       "each filter update: Neff, matches, likelihood, loop state, unique ancestors",
       false,
       [](const fs::path& file, const Material& m) {
         io::writeWhole(file, stepsCsv(m.result.record.reports));
       }},
      {{"loops.json"},
       "each loop: detection, entry, what was saved, what recovery brought back",
       false,
       [](const fs::path& file, const Material& m) {
         io::writeWhole(file, loopsJson(m.result.closings, m.result.found, m.result.record.reports,
                                        m.result.config.slam.loop_closing.opportunity));
       }},
      {{"report.html"},
       "the run to replay in a browser: map, particles, path, loops, curves",
       true,
       [](const fs::path& file, const Material& m) { report::writeReport(file, m.result.replay); }},
      {{"overview.png"},
       "picture of the path on the map: look at this first",
       true,
       [](const fs::path& file, const Material& m) {
         report::writeOverview(file, m.map, m.result.path);
       }},
      {{"topology.png"},
       "the graph of places over the map, with the loops that were closed",
       true,
       [](const fs::path& file, const Material& m) {
         writeTopologyPicture(file, m.mapper, m.map);
       }},
      {{"coalescence.png"},
       "unique ancestors at every past update: where hypotheses were lost and recovered",
       true,
       [](const fs::path& file, const Material& m) { writeCoalescencePicture(file, m.mapper); }},
      {{"map.png"},
       "the map as a plain picture",
       true,
       [](const fs::path& file, const Material& m) { io::writeMapPng(file, m.map); }},
      {{"map.pgm", "map.yaml"},
       "the map for ROS map_server",
       false,
       [](const fs::path& file, const Material& m) { io::writeRosMap(file, m.map); }},
      {{"map.gridmap.gz"},
       "the map for MRPT (COccupancyGridMap2D)",
       false,
       [](const fs::path& file, const Material& m) { io::writeGridmap(file, m.map); }},
      {{"map.simplemap"},
       "scans and poses for MRPT (CSimpleMap)",
       false,
       [](const fs::path& file, const Material& m) {
         io::writeSimplemap(file, m.mapper.simpleMap());
       }},
  };
  return outputs;
}

constexpr const char* kSummary = "summary.json";

bool isAboutLoops(const Output& o) {
  const std::string& name = o.names.front();
  return name == "loops.json" || name == "topology.png" || name == "coalescence.png";
}

void checkNotEmpty(const Grid& map) {
  // Cells are exactly 0 until a beam has touched them.
  for (const auto cell : map.getRawMap())
    if (cell != 0) return;
  throw core::Error(
      "the map is empty: no beam of any scan could be inserted (see the warnings above, and "
      "[grid] insert_range_m)");
}

}  // namespace

Output mappingIni(const std::string& name) {
  return {{name}, "all parameters of this run, each explained", false, writeConfig};
}

std::vector<Output> mappingOutputs(const SlamConfig& config) {
  std::vector<Output> chosen;
  for (const Output& o : allOutputs())
    if ((config.run.pictures || !o.is_picture) &&
        (config.slam.loop_closing.enabled || !isAboutLoops(o)))
      chosen.push_back(o);
  return chosen;
}

std::vector<std::string> namesOf(const std::vector<Output>& outputs) {
  std::vector<std::string> names;
  for (const Output& o : outputs) names.insert(names.end(), o.names.begin(), o.names.end());
  names.emplace_back(kSummary);
  return names;
}

void writeOutputs(const fs::path& folder, const std::vector<Output>& outputs,
                  const slam::Mapper& mapper, const RunResult& result, const SummaryText& summary,
                  std::ostream& out) {
  const auto start = std::chrono::steady_clock::now();
  const Grid map = mapper.map();
  checkNotEmpty(map);
  const Material material{mapper, result, map};
  std::vector<std::string> written;
  std::vector<std::string> problems;
  const auto attempt = [&](const std::vector<std::string>& names, const std::string& purpose,
                           const auto& write) {
    try {
      write();
      written.insert(written.end(), names.begin(), names.end());
      fmt::print(out, "  {:<18} {}\n", fmt::format("{}", fmt::join(names, ", ")), purpose);
    } catch (const charts::GnuplotMissing& e) {  // the run has all its numbers
      fmt::print(out, "  {:<18} left out: {}\n", names.front(), e.what());
    } catch (const std::exception& e) {
      problems.emplace_back(e.what());
    }
  };
  fmt::print(out, "In {}:\n", folder.string());
  for (const Output& o : outputs)
    attempt(o.names, o.purpose, [&] { o.write(folder / o.names.front(), material); });
  attempt({kSummary}, "figures, costs, versions and warnings of this run", [&] {
    std::vector<std::string> files = written;
    files.emplace_back(kSummary);
    io::writeWhole(folder / kSummary, summary(secondsSince(start), files));
  });
  if (!problems.empty())
    throw core::Error(fmt::format("not all files are written: {}", fmt::join(problems, "; ")));
}

}  // namespace ariadne::slam_app
