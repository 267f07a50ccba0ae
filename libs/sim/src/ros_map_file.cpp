#include "ros_map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ariadne/io/picture_file.h"
#include "ariadne/io/ros_map_file.h"
#include "floor_plan.h"

namespace ariadne::sim {
namespace {

using Mode = io::RosMapFile::Mode;
using Shades = std::array<bool, 256>;  // which are floor

/// As map_server's image_loader.cpp and nav2's map_io.cpp threshold a pixel.
Shades floorShades(const io::RosMapFile& map) {
  Shades floor{};
  for (int shade = 0; shade < 256; ++shade) {
    const double bright = shade / 255.0;
    const double occupied = map.negate ? bright : 1 - bright;
    // nav2's saver takes a percentage for free by the same bound.
    floor[static_cast<std::size_t>(shade)] =
        map.mode == Mode::raw ? shade <= std::rint(100 * map.free_thresh)
                              : occupied < map.free_thresh && occupied <= map.occupied_thresh;
  }
  return floor;
}

/// A shade that stands for something comes more often than all that are about as bright.
bool isCode(const io::PicturePixels& picture, int shade) {
  constexpr int kAround = 10;
  std::array<std::size_t, 256> count{};
  for (std::size_t i = 0; i < picture.shade.size(); ++i)
    if (picture.opaque(i)) ++count[picture.shade[i]];
  std::size_t around = 0;
  for (int s = std::max(0, shade - kAround); s <= std::min(255, shade + kAround); ++s)
    if (s != shade) around += count[static_cast<std::size_t>(s)];
  return count[static_cast<std::size_t>(shade)] > around;
}

/// Takes the savers' gray for unknown out of the floor.
void exceptUnknown(const io::RosMapFile& map, const io::PicturePixels& picture, Shades& floor,
                   std::vector<std::string>& notes) {
  const int unknown = map.negate ? 50 : 205;
  bool& is_floor = floor[static_cast<std::size_t>(unknown)];
  if (map.mode != Mode::trinary || !is_floor || !isCode(picture, unknown)) return;
  is_floor = false;
  notes.push_back(fmt::format(
      "free_thresh {} would make floor of gray {}, which ROS's map savers write for unknown: it is "
      "read as unknown; free_thresh: 0.196 says so",
      map.free_thresh, unknown));
}

}  // namespace

mrpt::maps::COccupancyGridMap2D readRosMap(const std::filesystem::path& yaml,
                                           std::vector<std::string>& notes) {
  const io::RosMapFile map = io::readRosMapFile(yaml);
  const io::PicturePixels picture = io::readPicture(map.picture);
  Shades floor = floorShades(map);
  exceptUnknown(map, picture, floor, notes);
  return placedGrid(FloorPlan(picture, floor), map.resolution_m, map.map_from_picture,
                    yaml.string());
}

}  // namespace ariadne::sim
