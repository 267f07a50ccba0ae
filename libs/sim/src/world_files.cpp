#include <fmt/format.h>

#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/sim/world.h"
#include "gridmap_file.h"
#include "map_checks.h"
#include "ros_map_file.h"
#include "script_lines.h"
#include "world_cells.h"

namespace ariadne::sim {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

// Brightness over which ROS map_server calls a pixel free by default (free_thresh 0.196).
constexpr float kFloor = 0.81F;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw core::Error(fmt::format("{}: {}", path.string(), why));
}

/// Runs a loader of MRPT's, which throw or say false.
template <class Load>
void load(const std::filesystem::path& path, const char* what, Load&& f) {
  expectReadable(path);
  bool fine = false;
  std::string why;
  try {
    fine = f();
  } catch (const std::exception& e) {
    why = std::string(": ") + e.what();
    why = why.substr(0, why.find('\n'));
  }
  if (!fine) fail(path, fmt::format("cannot be read as {}{}", what, why));
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
  Grid map;
  if (endsWith(name, ".yaml") || endsWith(name, ".yml")) {
    load(path, "a map of ROS map_server", [&] {
      map = readRosMap(path);
      return true;
    });
    return worldOf(path, std::move(map));
  }
  if (endsWith(name, ".gridmap") || endsWith(name, ".gridmap.gz")) {
    load(path, "an MRPT gridmap", [&] {
      map = readGridmap(path);
      return true;
    });
    return worldOf(path, std::move(map));
  }
  for (const char* picture : {".png", ".pgm", ".bmp", ".jpg"})
    if (endsWith(name, picture))
      fail(path, "a picture does not say how large its pixels are: give world_resolution_m");
  return parseWorld(readScript(path), path.string());
}

World readWorldPicture(const std::filesystem::path& path, double resolution_m) {
  if (!(resolution_m >= 0.01 && resolution_m <= 0.5))
    throw core::UsageError(
        fmt::format("a picture's resolution is {} m; it takes 0.01 to 0.5", resolution_m));
  Grid map;
  load(path, "a picture", [&] {
    expectPictureCells(path);
    return map.loadFromBitmapFile(path.string(), static_cast<float>(resolution_m), {0, 0});
  });
  return worldOf(path, std::move(map));
}

}  // namespace ariadne::sim
