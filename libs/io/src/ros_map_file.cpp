#include "ariadne/io/ros_map_file.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/io/yaml.h"

namespace ariadne::io {
namespace {

namespace fs = std::filesystem;

constexpr double kFarthestOrigin_m = 1e5;
constexpr double kWholeTurn = 6.2832;  // what is more is meant in degrees

fs::path pictureIn(const YamlValue& document, const fs::path& yaml) {
  const YamlValue image = document.at("image", "image: map.pgm");
  const std::string name = image.text();
  if (name.empty()) throw image.error("names no file, as in image: map.pgm does");
  return yaml.parent_path() / name;
}

RosMapFile::Mode modeIn(const YamlValue& document) {
  const auto mode = document.find("mode");
  if (!mode) return RosMapFile::Mode::trinary;
  const std::string name = mode->text();
  if (core::equalIgnoringCase(name, "trinary")) return RosMapFile::Mode::trinary;
  if (core::equalIgnoringCase(name, "scale")) return RosMapFile::Mode::scale;
  if (core::equalIgnoringCase(name, "raw")) return RosMapFile::Mode::raw;
  throw mode->error(fmt::format("\"{}\"; takes trinary, scale or raw", core::printable(name)));
}

mrpt::math::TPose2D originIn(const YamlValue& document) {
  const YamlValue origin = document.at("origin", "origin: [-10.0, -10.0, 0.0]");
  if (origin.size() != 3)
    throw origin.error(
        fmt::format("{} values; takes 3, x and y in m and yaw in rad, as in "
                    "[-10.0, -10.0, 0.0]",
                    origin.size()));
  return {origin[0].number(-kFarthestOrigin_m, kFarthestOrigin_m),
          origin[1].number(-kFarthestOrigin_m, kFarthestOrigin_m),
          std::remainder(origin[2].number(-kWholeTurn, kWholeTurn), 2 * M_PI)};
}

}  // namespace

RosMapFile readRosMapFile(const fs::path& yaml) {
  const YamlValue document = readYaml(yaml);
  RosMapFile map;
  map.picture = pictureIn(document, yaml);
  map.mode = modeIn(document);
  map.resolution_m = document.at("resolution", "resolution: 0.05").number(0.005, 0.5);
  map.map_from_picture = originIn(document);
  const YamlValue negate = document.at("negate", "negate: 0");
  map.negate = negate.flag();
  const YamlValue occupied = document.at("occupied_thresh", "occupied_thresh: 0.65");
  map.occupied_thresh = occupied.number(0, 1);
  const YamlValue free = document.at("free_thresh", "free_thresh: 0.196");
  map.free_thresh = free.number(0, 1);
  // There the two servers read a pixel differently.
  if (map.free_thresh > map.occupied_thresh)
    throw free.error(fmt::format("{} is over occupied_thresh, {}; takes what is under it",
                                 map.free_thresh, map.occupied_thresh));
  if (map.mode == RosMapFile::Mode::raw && map.negate)
    throw negate.error("goes with modes trinary and scale; raw takes 0");
  return map;
}

std::optional<fs::path> pictureOfRosMap(const fs::path& yaml) {
  std::error_code ignored;
  try {
    const fs::path picture = pictureIn(readYaml(yaml), yaml);
    if (fs::is_regular_file(picture, ignored)) return picture;
  } catch (const core::Error&) {  // no map; who reads it as one says so
  }
  return std::nullopt;
}

}  // namespace ariadne::io
