#include "continuation.h"

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ariadne/core/error.h"
#include "ariadne/io/simplemap_file.h"
#include "ariadne/models/scan_odometry.h"
#include "ariadne/slam/start_search.h"
#include "config.h"

namespace ariadne::slam_app {
namespace {

using mrpt::math::TPose2D;
using Result = slam::StartSearch::Result;

/// x,y,deg, also with blanks between; nothing when it is empty.
std::optional<TPose2D> parseStart(const std::string& text) {
  if (text.find_first_not_of(" \t") == std::string::npos) return std::nullopt;
  std::string blanks = text;
  std::replace(blanks.begin(), blanks.end(), ',', ' ');
  double x = 0, y = 0, deg = 0;
  char more = 0;
  const bool whole = std::sscanf(blanks.c_str(), "%lf %lf %lf %c", &x, &y, &deg, &more) == 3;
  if (!whole || !(std::abs(x) < 1e5 && std::abs(y) < 1e5 && std::abs(deg) <= 3600))
    throw core::UsageError(fmt::format(
        "[continue] start = {}: it takes x and y in m and the heading in degrees, as in "
        "3.5,-2,90",
        text));
  return TPose2D(x, y, mrpt::math::wrapToPi(mrpt::DEG2RAD(deg)));
}

std::string inWords(const TPose2D& p) {
  return fmt::format("{:.2f},{:.2f},{:.0f}", p.x, p.y, mrpt::RAD2DEG(p.phi));
}

constexpr const char* kGive =
    "say where the robot is at the first scan: --start x,y,deg, to 1 m and 15 degrees";

core::Error notFound(const slam::StartSearch& search, const std::optional<TPose2D>& given,
                     const std::string& file) {
  if (given)
    return core::Error(fmt::format(
        "the log's first scans do not fit the map about --start {}: {:.2f} of 1 at best, at {}; "
        "correct --start, or leave it out to have the place searched for",
        inWords(*given), search.best.field, inWords(search.best.map_from_robot)));
  if (search.result == Result::unlike)
    return core::Error(fmt::format(
        "the log's first scans fit nowhere in {}: {:.2f} of 1 at best. If they were taken in this "
        "building, {}",
        file, search.best.field, kGive));
  return core::Error(fmt::format(
      "the log's first scans fit several places in {}: {:.2f} of 1 at {}, and {:.2f} at {}; {}",
      file, search.best.field, inWords(search.best.map_from_robot), search.rival->field,
      inWords(search.rival->map_from_robot), kGive));
}

}  // namespace

std::filesystem::path simplemapOf(const std::filesystem::path& run) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::exists(run, ignored))
    throw core::Error(fmt::format("there is no {} to go on from", run.string()));
  if (!fs::is_directory(run, ignored)) return run;
  if (!fs::exists(run / "map.simplemap", ignored))
    throw core::Error(
        fmt::format("there is no map.simplemap in {}: name the folder of a finished run of "
                    "ariadne-slam or ariadne-explore, or a .simplemap",
                    run.string()));
  return run / "map.simplemap";
}

Continuation continuationOf(const SlamConfig& config, io::StepSource& source) {
  Continuation out;
  const auto given = parseStart(config.continue_from.start);
  out.map_file = simplemapOf(config.continue_from.run).string();
  out.known = io::readSimplemap(out.map_file);
  out.scans = out.known.size();
  std::optional<models::ScanOdometry> by_scans;
  if (config.dataset.odometry == OdometrySource::scans)
    by_scans.emplace(config.slam.grid, config.slam.matcher, config.slam.filter.proposal_gain);
  const auto next = [&] {
    auto step = source.next();
    if (step && by_scans) step->odom_from_robot = by_scans->add(*step);
    return step;
  };
  const auto search = slam::searchStart(config.slam, config.run.threads, out.known, next, given);
  if (search.result == Result::unlike || search.result == Result::ambiguous)
    throw notFound(search, given, out.map_file);
  out.start = search.best.map_from_robot;
  out.field = search.best.field;
  out.searched = !given;
  out.note = fmt::format("Goes on in {} from {}", out.map_file, inWords(out.start));
  if (search.result == Result::unmapped)
    out.note += ", as given: the map does not show what is about there";
  return out;
}

}  // namespace ariadne::slam_app
