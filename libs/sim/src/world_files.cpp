#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/io/picture_file.h"
#include "ariadne/sim/world.h"
#include "floor_plan.h"
#include "gridmap_file.h"
#include "ros_map_file.h"
#include "script_lines.h"
#include "world_cells.h"

namespace ariadne::sim {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

// Probability over which MRPT's cells are free, with the steps that they are kept in.
constexpr float kFloor = 0.81F;
// The darkest gray that ROS map_server calls free by default (free_thresh 0.196).
constexpr std::ptrdiff_t kDarkestFloor = 206;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw core::Error(fmt::format("{}: {}", path.string(), why));
}

Grid gridmapOf(const std::filesystem::path& path) {
  expectReadable(path);
  try {
    return readGridmap(path);
  } catch (const std::exception& e) {
    const std::string why = e.what();
    fail(path, "cannot be read as an MRPT gridmap: " + why.substr(0, why.find('\n')));
  }
}

World worldOf(const std::filesystem::path& path, Grid map) {
  if (map.getResolution() < 0.005F || map.getResolution() > 0.5F)
    fail(path,
         fmt::format("cells of {} m; a world has cells of 0.005 to 0.5 m", map.getResolution()));
  bool floor = false;
  for (unsigned y = 0; y < map.getSizeY(); ++y)
    for (unsigned x = 0; x < map.getSizeX(); ++x) {
      const bool free = map.getCell(static_cast<int>(x), static_cast<int>(y)) > kFloor;
      floor |= free;
      map.setCell(static_cast<int>(x), static_cast<int>(y), free ? kFree : kRock);
    }
  if (!floor) fail(path, "no free cell in it");
  World world;
  world.name = path.string();
  world.bodies = map;
  world.map = std::move(map);
  return world;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

World readWorld(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (endsWith(name, ".yaml") || endsWith(name, ".yml")) {
    std::vector<std::string> notes;
    World world = worldOf(path, readRosMap(path, notes));
    for (const std::string& note : notes) world.notes.push_back(path.string() + ": " + note);
    return world;
  }
  if (endsWith(name, ".gridmap") || endsWith(name, ".gridmap.gz"))
    return worldOf(path, gridmapOf(path));
  for (const char* picture : {".png", ".pgm", ".bmp", ".jpg"})
    if (endsWith(name, picture))
      fail(path, "a picture does not say how large its pixels are: give world_resolution_m");
  return parseWorld(readScript(path), path.string());
}

World readWorldPicture(const std::filesystem::path& path, double resolution_m) {
  if (!(resolution_m >= 0.01 && resolution_m <= 0.5))
    throw core::UsageError(
        fmt::format("a picture's resolution is {} m; it takes 0.01 to 0.5", resolution_m));
  std::array<bool, 256> floor{};
  std::fill(floor.begin() + kDarkestFloor, floor.end(), true);
  return worldOf(
      path, placedGrid(FloorPlan(io::readPicture(path), floor), resolution_m, {}, path.string()));
}

}  // namespace ariadne::sim
